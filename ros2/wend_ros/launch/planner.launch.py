# SPDX-License-Identifier: Apache-2.0
"""The planner and rviz: ros2 launch wend_ros planner.launch.py planner:=astar robot_radius:=0.2

The map comes on the topic `map`, from Nav2's map server or a mapping node.
"""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    share = get_package_share_directory('wend_ros')
    return LaunchDescription([
        DeclareLaunchArgument('planner', default_value='astar',
                              description='a name of `wend planners`'),
        DeclareLaunchArgument('robot_radius', default_value='0.2', description='m'),
        DeclareLaunchArgument('params_file',
                              default_value=os.path.join(share, 'config', 'planner.yaml'),
                              description='more parameters of the node'),
        DeclareLaunchArgument('rviz', default_value='true', description='show it'),
        Node(package='wend_ros', executable='planner_server', name='planner_server',
             output='screen', respawn=True, respawn_delay=1.0,
             parameters=[LaunchConfiguration('params_file'),
                         {'planner': LaunchConfiguration('planner'),
                          'robot_radius': ParameterValue(LaunchConfiguration('robot_radius'),
                                                         value_type=float)}]),
        Node(package='rviz2', executable='rviz2', name='rviz2',
             condition=IfCondition(LaunchConfiguration('rviz')),
             arguments=['-d', os.path.join(share, 'rviz', 'planner.rviz')]),
    ])
