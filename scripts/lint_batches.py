#!/usr/bin/env python3
"""Puts the sources of each target together for clang-tidy, which takes longest over the headers that they share.

  lint_batches.py COMPILE_COMMANDS DIRECTORY FOLDER...

Writes DIRECTORY/compile_commands.json: sources below FOLDER... that can be compiled as one in a batch, others one by
one. Names that several unnamed namespaces of a batch define are numbered by macros. A source that is compiled for both
of Bullet's precisions is checked once.
"""
import collections
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys

BATCH_SIZE = 16


def once_each(commands, folders):
    """The last command of each source below one of the folders."""
    once = {command["file"]: command for command in commands}
    return [command for file, command in once.items() if file.startswith(folders)]


def by_target(commands):
    """Commands of the same target and flags, those without "-o OUTPUT -c SOURCE"."""
    targets = collections.defaultdict(list)
    for command in commands:
        flags, target = re.fullmatch(r"(.*) -o (\S+)\.dir/\S+ -c \S+", command["command"]).groups()
        targets[target, flags].append(command)
    return targets


def batch(flags, members, names, path):
    """The command of one source, written to `path`, that includes those of `members`. `names` get a number in each."""
    with open(path, "w") as source:
        for number, member in enumerate(members):
            source.writelines(f"#define {name} {name}{number}  // NOLINT\n" for name in sorted(names))
            source.write(f'#include "{member["file"]}"  // NOLINT: not a header\n')
            source.writelines(f"#undef {name}\n" for name in sorted(names))
    return {"directory": members[0]["directory"], "file": path, "command": f"{flags} -c {path}"}


def obstacles(command):
    """The sources in which clang finds errors when a batch is compiled, and the names that they define again."""
    compiler = ["clang++", "-fsyntax-only", "-w", "-ferror-limit=0"] + shlex.split(command["command"])[1:]
    messages = subprocess.run(compiler, cwd=command["directory"], capture_output=True, text=True).stderr
    errors = re.findall(r"^(\S+?):\d+:\d+: (?:fatal )?error: (.*)", messages, re.MULTILINE)
    again = [re.match(r"(?:redefinition of|call to) '(\w+)'", error) for _, error in errors]
    return {file for file, _ in errors}, {match[1] for match in again if match}


def chunks_of(targets):
    """Up to BATCH_SIZE sources of one target each, with their flags."""
    for (_, flags), members in targets.items():
        members.sort(key=lambda member: member["file"])
        chunk_count = -(-len(members) // BATCH_SIZE)
        for number in range(chunk_count):
            yield flags, members[number::chunk_count]


def commands_of(flags, members, path):
    """One for all that can be compiled together, and one for each of the others."""
    alone = []
    names = set()
    while len(members) > 1:
        together = batch(flags, members, names, path)
        in_the_way, again = obstacles(together)
        if not in_the_way:
            return alone + [together]
        if again - names:
            names |= again
            continue
        rest = [member for member in members if member["file"] not in in_the_way]
        if len(rest) == len(members):  # the error is in a header
            break
        alone += [member for member in members if member["file"] in in_the_way]
        members = rest
    return alone + members


def main():
    commands_file, directory = sys.argv[1], os.path.abspath(sys.argv[2])
    folders = tuple(os.path.abspath(folder) + os.sep for folder in sys.argv[3:])
    os.makedirs(directory, exist_ok=True)
    with open(commands_file) as file:
        commands = json.load(file)
    chunks = chunks_of(by_target(once_each(commands, folders)))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        results = [workers.submit(commands_of, flags, members, f"{directory}/batch_{number}.cpp")
                   for number, (flags, members) in enumerate(chunks)]
    with open(f"{directory}/compile_commands.json", "w") as file:
        json.dump([command for result in results for command in result.result()], file, indent=1)


if __name__ == "__main__":
    main()
