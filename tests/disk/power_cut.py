#!/usr/bin/env python3
"""What a disk holds after the power is lost.

    power_cut.py count LOG
    power_cut.py make LOG CHANGES SEED FOLDER NEW_FOLDER

LOG is what disk_faults.c has written of the changes in FOLDER. `count` prints how many there are. `make` makes
NEW_FOLDER as FOLDER would be after the power was lost behind the first CHANGES of them. Of what was not synced, the
disk has nothing where SEED is 0; otherwise any part of each file's writes, and of each folder's changes those up to
any one: a disk writes in whatever order it likes, and a file system keeps the order of the names in a folder.
"""

import os
import random
import sys


class File:
    def __init__(self):
        self.synced = bytearray()
        self.later = []  # (offset, data) of a write, (size, None) of a truncation

    def content(self, keep):
        content = bytearray(self.synced)
        for offset, data in filter(keep, self.later):
            if data is None:
                del content[offset:]
                content.extend(bytes(offset - len(content)))
            else:
                content.extend(bytes(max(0, offset - len(content))))
                content[offset : offset + len(data)] = data
        return content

    def sync(self):
        self.synced = self.content(lambda change: True)
        self.later = []


class Folder:
    def __init__(self):
        self.synced = {}  # name: File
        self.now = {}
        self.later = []  # what it held after each change

    def change(self, gone, name=None, file=None):
        self.now.pop(gone, None)
        if file:
            self.now[name] = file
        self.later.append(dict(self.now))

    def sync(self):
        self.synced, self.later = dict(self.now), []


class Disk:
    def __init__(self):
        self.files, self.folders = {}, {}

    def folder(self, path):
        return self.folders.setdefault(path, Folder())

    def apply(self, what, inode, offset, path, other, data):
        folder, name = self.folder(os.path.dirname(path)), os.path.basename(path)
        if what == "make":
            self.files[inode] = File()
            folder.change(name, name, self.files[inode])
        elif what == "write":
            self.files.setdefault(inode, File()).later.append((offset, data))
        elif what == "truncate":
            self.files.setdefault(inode, File()).later.append((offset, None))
        elif what == "sync":
            if path in self.folders:
                self.folders[path].sync()
            else:
                self.files.setdefault(inode, File()).sync()
        elif what == "rename":
            assert os.path.dirname(other) == os.path.dirname(path), "a rename to another folder"
            folder.change(name, os.path.basename(other), folder.now.get(name))
        elif what == "remove":
            folder.change(name)

    def write(self, dice, old, new):
        os.makedirs(new)
        for path, folder in self.folders.items():
            states = [folder.synced] + folder.later
            names = states[dice.randrange(len(states))] if dice else folder.synced
            place = new + path[len(old) :]
            os.makedirs(place, exist_ok=True)
            for name, made in names.items():
                keep = (lambda change: dice.random() < 0.5) if dice else (lambda change: False)
                with open(os.path.join(place, name), "wb") as file:
                    file.write(made.content(keep))


def changes_in(log):
    with open(log, "rb") as file:
        while head := file.readline():
            what, inode, offset, size, path, other = head.decode().rstrip("\n").split("\t")
            yield what, int(inode), int(offset), path, other, file.read(int(size))


def main(words):
    if words[0] == "count":
        print(sum(1 for _ in changes_in(words[1])))
        return
    log, count, seed, old, new = words[1:]
    disk = Disk()
    for number, change in enumerate(changes_in(log)):
        if number == int(count):
            break
        disk.apply(*change)
    disk.write(random.Random(int(seed)) if int(seed) else None, os.path.realpath(old), new)


main(sys.argv[1:])
