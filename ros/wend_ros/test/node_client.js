#!/usr/bin/env node
// An independent client: rosnodejs calls the service and the action, and what comes back is checked
// against the map file, cell by cell. Run by node_client.test; writes its results as JUnit XML.

'use strict';

const fs = require('fs');
const path = require('path');
const rosnodejs = require('rosnodejs');

const kSeconds = 30;
const room = fs.readFileSync(path.join(__dirname, 'room.txt'), 'utf8').trim().split('\n');

function check(condition, what) {
  if (!condition) throw new Error(what);
}

/// Is that cell free? y counts from the bottom, as in the messages.
function isFree(x, y) {
  const row = room[room.length - 1 - y];
  return row !== undefined && row[x] === '.';
}

/// Walks the path as a person would, and returns what it costs.
function costOf(poses) {
  let cost = 0;
  for (let i = 0; i < poses.length; ++i) {
    const x = Math.floor(poses[i].pose.position.x);
    const y = Math.floor(poses[i].pose.position.y);
    check(isFree(x, y), `(${x},${y}) is blocked`);
    if (i === 0) continue;
    const dx = x - Math.floor(poses[i - 1].pose.position.x);
    const dy = y - Math.floor(poses[i - 1].pose.position.y);
    check(Math.abs(dx) <= 1 && Math.abs(dy) <= 1, 'a step is too long');
    check(isFree(x - dx, y) && isFree(x, y - dy), 'a corner is cut');
    cost += Math.hypot(dx, dy);
  }
  return cost;
}

/// The cheapest cost, by relaxing all cells until nothing changes.
function cheapest(start, goal) {
  const side = room.length;
  const costs = Array.from({length: side}, () => Array(side).fill(Infinity));
  costs[start[1]][start[0]] = 0;
  for (let changed = true; changed;) {
    changed = false;
    for (let y = 0; y < side; ++y) {
      for (let x = 0; x < side; ++x) {
        if (!isFree(x, y)) continue;
        for (let dy = -1; dy <= 1; ++dy) {
          for (let dx = -1; dx <= 1; ++dx) {
            if (!isFree(x + dx, y + dy) || !isFree(x + dx, y) || !isFree(x, y + dy)) continue;
            const cost = costs[y][x] + Math.hypot(dx, dy);
            if (cost < costs[y + dy][x + dx] - 1e-9) {
              costs[y + dy][x + dx] = cost;
              changed = true;
            }
          }
        }
      }
    }
  }
  return costs[goal[1]][goal[0]];
}

function pose(x, y) {
  return {
    header: {seq: 0, stamp: {secs: 0, nsecs: 0}, frame_id: 'map'},
    pose: {position: {x, y, z: 0}, orientation: {x: 0, y: 0, z: 0, w: 1}},
  };
}

const request = {
  use_start: true,
  start: pose(1.5, 1.5),
  goals: [pose(38.5, 5.5)],
  any_heading: false,
  planner: 'astar',
  options: 'heuristic=octile',
  time_limit: 0,
  from_field: false,
};

async function serviceAnswers(node) {
  const client = node.serviceClient('/plan_path', 'wend_ros/PlanPath');
  await node.waitForService('/plan_path', 1000 * kSeconds);
  for (let i = 0; i < 100; ++i) {  // until the map has come
    const {result} = await client.call({request});
    if (result.status === 250) {
      await new Promise((done) => setTimeout(done, 100));
      continue;
    }
    check(result.status === 0, `status ${result.status}: ${result.reason}`);
    const cost = costOf(result.path.poses);
    check(Math.abs(cost - result.cost) < 1e-6, `cost ${result.cost}, walked ${cost}`);
    const best = cheapest([1, 1], [38, 5]);
    check(Math.abs(cost - best) < 1e-6, `cost ${cost}, the cheapest is ${best}`);
    return;
  }
  throw new Error('no map came');
}

async function serviceTellsWhyNot(node) {
  const client = node.serviceClient('/plan_path', 'wend_ros/PlanPath');
  const {result} = await client.call({request: {...request, goals: [pose(20.5, 5.5)]}});
  check(result.status === 206, `status ${result.status}, 206 expected`);
  check(result.reason.length > 0, 'no reason was given');
}

async function actionSucceeds(node) {
  const actionlib = rosnodejs.require('actionlib_msgs');
  check(actionlib.msg.GoalStatus.Constants.SUCCEEDED === 3, 'not the messages of actionlib');
  const client = new rosnodejs.SimpleActionClient(
      {nh: node, type: 'wend_ros/PlanPath', actionServer: '/plan_path_action'});
  check(await client.waitForServer({secs: kSeconds, nsecs: 0}), 'there is no action server');
  client.sendGoal({request});
  check(await client.waitForResult({secs: kSeconds, nsecs: 0}), 'no result came');
  const {result} = client.getResult();
  check(result.status === 0, `status ${result.status}: ${result.reason}`);
  check(Math.abs(costOf(result.path.poses) - result.cost) < 1e-6, 'a wrong cost');
}

function escaped(text) {
  return text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
}

async function main() {
  const option = process.argv.find((word) => word.startsWith('--gtest_output=xml:'));
  const node = await rosnodejs.initNode('/node_client_test', {onTheFly: true});
  const cases = [];
  let failures = 0;
  for (const test of [serviceAnswers, serviceTellsWhyNot, actionSucceeds]) {
    let failure = '';
    try {
      await test(node);
    } catch (error) {
      ++failures;
      failure = `<failure message="${escaped(String(error.message || error))}"/>`;
      console.error(test.name, error);
    }
    cases.push(`<testcase name="${test.name}" classname="NodeClient">${failure}</testcase>`);
  }
  const xml = `<?xml version="1.0"?>\n<testsuite name="NodeClient" tests="${cases.length}" ` +
      `failures="${failures}" errors="0" time="0">${cases.join('')}</testsuite>\n`;
  if (option) fs.writeFileSync(option.slice('--gtest_output=xml:'.length), xml);
  process.exit(failures === 0 ? 0 : 1);
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
