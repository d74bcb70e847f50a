# SPDX-License-Identifier: MIT
# read_dataset.py SHARD: what h5py finds in it, a line for each table's lists of names and for each
# column: path, shape and the SHA-256 of its bytes, as read_shard.mjs of tools/lerobot/tests prints
# it by h5wasm. With --pandas: joins the tables as data frames, and prints what does not fit, or the
# counts. With --index FOLDER: the same of a folder's index, whose columns are also set beside the
# shards'.
import glob
import hashlib
import os
import sys

import h5py
import numpy
import pandas


def texts(values):
    return [text.decode() for text in values]


def shown(name, member):
    lines = []
    for key, value in member.attrs.items():
        if getattr(value, 'shape', ()):
            lines.append(f"/{name}@{key} {' '.join(texts(value))}")
    if isinstance(member, h5py.Dataset):
        values = member[()]
        is_text = values.dtype.kind == 'S'
        # the plan is a single text
        data = '\n'.join(texts(numpy.atleast_1d(values))).encode() if is_text else values.tobytes()
        shape = 'x'.join(str(side) for side in values.shape)
        lines.append(f'/{name} {shape} {hashlib.sha256(data).hexdigest()}')
    return lines


def show(file):
    lines = []
    file.visititems(lambda name, member: lines.extend(shown(name, member)))
    print('\n'.join(sorted(lines)))


def frame(group):
    """The columns of one number or text a row."""
    columns = {}
    for name, dataset in group.items():
        if dataset.ndim != 1:
            continue
        values = dataset[()]
        if 'words' in dataset.attrs:
            values = pandas.Categorical.from_codes(values, texts(dataset.attrs['words']))
        elif dataset.dtype.kind == 'S':
            values = texts(values)
        columns[name] = values
    return pandas.DataFrame(columns)


def join(file):
    tasks = frame(file['tasks']).set_index('task', verify_integrity=True)
    goals = frame(file['goals']).join(tasks, on='task', rsuffix='_of_task')
    motions = pandas.concat([frame(table) for table in file['motions'].values()])
    joined = motions.join(tasks, on='task', rsuffix='_of_task')
    wrong = []
    if joined['status'].isna().any() or goals['status'].isna().any():
        wrong.append('a row is of no task')
    counts = joined.groupby('task').size().reindex(tasks.index, fill_value=0)
    if not (counts == tasks['motions']).all():
        wrong.append('a task has not as many motions as its row tells')
    # a motion has its duration from the length of its 60 steps
    if not (joined['duration_s'] - joined['duration_s_of_task']).abs().le(1e-12).all():
        wrong.append('a motion does not take as long as its task tells')
    if not joined[joined['status'] == 'reached']['error_m'].le(1e-3).all():
        wrong.append('a motion that reaches is further than 1 mm from its goal')
    print('\n'.join(wrong) or f'{len(tasks)} {len(goals)} {len(motions)}')
    return len(wrong)


def is_column(file, path):
    # the plan, a single text, has no rows
    return path in file and isinstance(file[path], h5py.Dataset) and file[path].ndim > 0


def compare(index, folder):
    """Each column of the shards' tables is in the index, one shard after the other."""
    names = sorted(glob.glob(os.path.join(folder, 'shard-*.h5')))
    shards = [h5py.File(name, 'r') for name in names]
    paths = set()
    for shard in shards:
        shard.visit(paths.add)
    paths = [path for path in sorted(paths) if any(is_column(shard, path) for shard in shards)]
    wrong = []
    for path in paths:
        whole = numpy.concatenate([shard[path][()] for shard in shards if path in shard])
        if path not in index or index[path][()].tobytes() != whole.tobytes():
            wrong.append(f'{path} is not that of the shards')
    if list(index['splits/task'][()]) != list(index['tasks/task'][()]):
        wrong.append('the splits are of other tasks')
    print('\n'.join(wrong) or f'{len(shards)} {len(paths)}')
    return len(wrong)


if sys.argv[1] == '--index':
    with h5py.File(os.path.join(sys.argv[2], 'index.h5'), 'r') as index:
        sys.exit(compare(index, sys.argv[2]) + join(index))
with h5py.File(sys.argv[-1], 'r') as shard:
    sys.exit(join(shard) if sys.argv[1] == '--pandas' else show(shard))
