#!/usr/bin/python3
"""A real rviz under Xvfb: the map and the path are where they should be, pixel by pixel, and a click
with its "2D Nav Goal" makes the robot drive. Run by rviz.test.

With WEND_ROS_SCREENSHOT=FILE.png the last screenshot is kept.
"""

import math
import os
import subprocess
import sys
import time
import unittest

import rospkg
import rospy
import rosunit
from nav_msgs.msg import Odometry, Path
from std_msgs.msg import String

WIDTH, HEIGHT = 1280, 900
SIDE = 40  # cells of the map, a metre each
SCALE = 18  # pixels a metre
PATIENCE = 60  # s


class Screen:
    """A virtual X server with a window manager and rviz."""

    def __init__(self, config):
        read, write = os.pipe()
        self.processes = [subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-nolisten",
             "tcp", "+extension", "GLX"], pass_fds=[write], stderr=subprocess.DEVNULL)]
        os.close(write)
        with os.fdopen(read) as pipe:
            self.environment = {**os.environ, "DISPLAY": ":" + pipe.readline().strip(),
                                "LIBGL_ALWAYS_SOFTWARE": "1"}
        for command in (["openbox"], ["rviz", "-d", config]):
            self.processes.append(subprocess.Popen(command, env=self.environment,
                                                   stdout=subprocess.DEVNULL,
                                                   stderr=subprocess.DEVNULL))

    def close(self):
        for process in reversed(self.processes):
            process.terminate()
            process.wait()

    def pixels(self):
        """All of them, as rows of (red, green, blue)."""
        raw = subprocess.run(["import", "-window", "root", "-depth", "8", "rgb:-"],
                             env=self.environment, check=True, capture_output=True).stdout
        row = 3 * WIDTH
        return [[tuple(raw[y * row + 3 * x:y * row + 3 * x + 3]) for x in range(WIDTH)]
                for y in range(HEIGHT)]

    def save(self, file):
        subprocess.run(["import", "-window", "root", file], env=self.environment, check=True)

    def do(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True)


def is_free(pixel):
    """White: free cells. What is around the map is a little darker."""
    return min(pixel) > 250


def is_red(pixel):
    red, green, blue = pixel
    return red > 100 and green < 90 and blue < 90


class View:
    """Where the map lies on the screen: found by its colours, and checked to be to scale."""

    def __init__(self, pixels):
        self.pixels = pixels
        columns = [x for x in range(360, WIDTH - 20)
                   if any(is_free(pixels[y][x]) for y in range(70, HEIGHT - 40, 9))]
        rows = [y for y in range(70, HEIGHT - 40)
                if any(is_free(pixels[y][x]) for x in range(360, WIDTH - 20, 9))]
        self.left, self.top = (min(columns), min(rows)) if columns and rows else (0, 0)
        self.width = max(columns) + 1 - self.left if columns else 0
        self.height = max(rows) + 1 - self.top if rows else 0

    def is_to_scale(self):
        side = SIDE * SCALE
        return abs(self.width - side) <= 3 and abs(self.height - side) <= 3

    def place(self, x, y):
        """The pixel of a place in metres."""
        return round(self.left + x * SCALE), round(self.top + (SIDE - y) * SCALE)

    def at(self, x, y):
        column, row = self.place(x, y)
        return self.pixels[row][column]


class Rviz(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("rviz_test")
        cls.state, cls.robot, cls.plan = "", None, None
        rospy.Subscriber("follower/state", String, lambda m: setattr(cls, "state", m.data))
        rospy.Subscriber("odom", Odometry, lambda m: setattr(cls, "robot", m.pose.pose.position))
        rospy.Subscriber("plan_smoothed", Path, lambda m: setattr(cls, "plan", m))
        folder = os.path.join(rospkg.RosPack().get_path("wend_ros"), "test")
        cls.screen = Screen(os.path.join(folder, "room.rviz"))

    @classmethod
    def tearDownClass(cls):
        file = os.environ.get("WEND_ROS_SCREENSHOT")
        if file:
            cls.screen.save(file)
        cls.screen.close()

    def wait_until(self, condition, what):
        end = time.monotonic() + PATIENCE
        while not condition():
            self.assertLess(time.monotonic(), end, what)
            time.sleep(0.1)

    def view(self):
        """The map on the screen, once it is there."""
        seen = []

        def found():
            seen[:] = [View(self.screen.pixels())]
            return seen[0].is_to_scale()

        self.wait_until(found, "no map of the right size came on the screen")
        return seen[0]

    def test_1_the_map_is_where_it_should_be(self):
        def is_wall(x, y):
            return x == 20 and y < SIDE - 8

        cells = [(x, y) for x in range(SIDE) for y in range(SIDE)]
        walls = [(x + 0.5, y + 0.5) for x, y in cells if is_wall(x, y)]

        def walls_are_red():
            view = self.view()
            return all(is_red(view.at(x, y)) for x, y in walls)

        # rviz draws the costmap, which colours them, some time after the map.
        self.wait_until(walls_are_red, "every cell of the wall is red")
        view = self.view()
        free = sum(is_free(view.at(x + 0.5, y + 0.5)) for x, y in cells if not is_wall(x, y))
        self.assertGreater(free, 0.99 * (SIDE * SIDE - SIDE), "but for the robot, the rest is free")

    def test_2_a_click_makes_the_robot_drive(self):
        view = self.view()
        self.wait_until(lambda: self.robot is not None, "there is no robot")
        column, row = view.place(25, 34)
        self.screen.do("key", "g")
        self.screen.do("mousemove", column, row, "mousedown", 1)
        for i in range(1, 6):
            self.screen.do("mousemove", column + 8 * i, row)
        self.screen.do("mouseup", 1)
        self.wait_until(lambda: self.plan and self.plan.poses, "the click made no plan")
        goal = self.plan.poses[-1].pose.position
        self.assertLess(math.hypot(goal.x - 25, goal.y - 34), 1.5, "the goal is where it was clicked")
        self.wait_until(lambda: self.state == "reached", "the robot did not arrive")
        self.assertLess(math.hypot(self.robot.x - goal.x, self.robot.y - goal.y), 0.5)

    def test_3_the_path_is_where_it_should_be(self):
        view = self.view()
        start, end = self.plan.poses[0].pose.position, self.plan.poses[-1].pose.position
        on_path = 0
        places = self.plan.poses
        for stamped in places:
            point = stamped.pose.position
            column, row = view.place(point.x, point.y)
            near = [view.pixels[row + dy][column + dx] for dy in range(-2, 3) for dx in range(-2, 3)]
            on_path += any(not is_free(pixel) for pixel in near)
        self.assertEqual(on_path, len(places), f"from {start.x},{start.y} to {end.x},{end.y}")


if __name__ == "__main__":
    rosunit.unitrun("wend_ros", "rviz_test", Rviz)
