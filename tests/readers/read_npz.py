# SPDX-License-Identifier: MIT
# read_npz.py FILE ROOT [CSV]: reads arrays for controllers of robots by numpy, and the CSV of the same motion at the
# same rate. Fails where velocities are not the derivatives of positions, turns jump, or torques differ. Prints the rate, the
# shape of joint_pos and the first joint.
import csv
import sys

import numpy

file = numpy.load(sys.argv[1])
fps = float(file['fps'])
joints, bodies = list(file['joint_names']), list(file['body_names'])
positions, velocities = file['joint_pos'], file['joint_vel']
frames = len(positions)
assert positions.shape == (frames, 7 + len(joints)) and velocities.shape == (frames, 6 + len(joints))
for name, last in ('body_pos_w', 3), ('body_quat_w', 4), ('body_lin_vel_w', 3), ('body_ang_vel_w', 3):
    assert file[name].shape == (frames, len(bodies), last), name
assert file['contacts'].shape == (frames, len(file['contact_names'])) and file['contacts'].dtype == bool
assert file['contacts'].all()


def same(name, a, b, by):
    most = numpy.abs(a - b).max()
    assert most <= by, f'{name}: {most}'


same('joints', velocities[:, 6:], numpy.gradient(positions[:, 7:], 1 / fps, axis=0), 1e-9)
same('bodies', file['body_lin_vel_w'], numpy.gradient(file['body_pos_w'], 1 / fps, axis=0), 1e-9)
root = bodies.index(sys.argv[2])
same('root', positions[:, :3], file['body_pos_w'][:, root], 0)
same('its turn', positions[:, 3:7], file['body_quat_w'][:, root], 0)
same('its speed', velocities[:, :3], file['body_lin_vel_w'][:, root], 0)
same('its spin', velocities[:, 3:6], file['body_ang_vel_w'][:, root], 0)
turns = file['body_quat_w']
same('lengths', numpy.linalg.norm(turns, axis=-1), 1, 1e-12)
assert (turns[1:] * turns[:-1]).sum(axis=-1).min() > 0.9
rows = []
if len(sys.argv) > 3:
    with open(sys.argv[3]) as text:
        rows = list(csv.DictReader(text))
    assert len(rows) == frames
for k, joint in enumerate(joints):
    column = f'{joint} torque [N m]'
    if rows and column in rows[0]:
        same(column, file['torques'][:, k], numpy.array([float(row[column]) for row in rows]), 0)
print(fps, *positions.shape, joints[0])
