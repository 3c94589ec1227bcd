"""Counts the results of the ROS tests: ros_results.py FOLDER LEAST.

Fails if a test failed or did not come to an end, and if there are fewer than LEAST: a build that is
broken in a quiet way reports no tests, and no failures.
"""

import pathlib
import sys
import xml.etree.ElementTree

folder, least = pathlib.Path(sys.argv[1]), int(sys.argv[2])
passed, failed = 0, []
for file in sorted(folder.rglob("*.xml")):
    # What rostest writes of itself says only whether a program's results came.
    of_rostest = file.name.startswith("rostest-")
    for case in xml.etree.ElementTree.parse(file).iter("testcase"):
        name = f"{file.stem}: {case.get('classname')}.{case.get('name')}"
        if case.find("failure") is not None or case.find("error") is not None:
            failed.append(name)
        elif not of_rostest:
            passed += 1
for name in failed:
    print("FAILED", name)
if passed + len(failed) < least:
    print(f"only {passed + len(failed)} tests reported, at least {least} expected")
print(f"ros tests: {passed} passed, {len(failed)} failed")
sys.exit(0 if not failed and passed >= least else 1)
