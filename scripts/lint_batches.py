#!/usr/bin/env python3
"""Combines the sources of each target for clang-tidy, which spends most time on their shared headers.

  lint_batches.py COMPILE_COMMANDS DIRECTORY FOLDER...

Writes DIRECTORY/compile_commands.json for the sources below FOLDER...: those that compile together in batches, the
others one by one. Macros number the names that several unnamed namespaces of a batch define. A source that is compiled
for both of Bullet's precisions is checked once.
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
    """Returns the last command of each source below one of the folders."""
    once = {command["file"]: command for command in commands}
    return [command for file, command in once.items() if file.startswith(folders)]


def by_target(commands):
    """Groups commands by target and flags (the command without "-o OUTPUT -c SOURCE")."""
    targets = collections.defaultdict(list)
    for command in commands:
        flags, target = re.fullmatch(r"(.*) -o (\S+)\.dir/\S+ -c \S+", command["command"]).groups()
        targets[target, flags].append(command)
    return targets


def batch(flags, members, names, path):
    """Writes a source to `path` that includes `members`, numbering `names` in each. Returns its command."""
    with open(path, "w") as source:
        for number, member in enumerate(members):
            source.writelines(f"#define {name} {name}{number}  // NOLINT\n" for name in sorted(names))
            source.write(f'#include "{member["file"]}"  // NOLINT: not a header\n')
            source.writelines(f"#undef {name}\n" for name in sorted(names))
    return {"directory": members[0]["directory"], "file": path, "command": f"{flags} -c {path}"}


def obstacles(command):
    """Returns the sources in which Clang finds errors when it compiles a batch, and the names that they redefine."""
    compiler = ["clang++", "-fsyntax-only", "-w", "-ferror-limit=0"] + shlex.split(command["command"])[1:]
    messages = subprocess.run(compiler, cwd=command["directory"], capture_output=True, text=True).stderr
    errors = re.findall(r"^(\S+?):\d+:\d+: (?:fatal )?error: (.*)", messages, re.MULTILINE)
    again = [re.match(r"(?:redefinition of|call to) '(\w+)'", error) for _, error in errors]
    return {file for file, _ in errors}, {match[1] for match in again if match}


def chunks_of(targets):
    """Yields flags and up to BATCH_SIZE sources of one target."""
    for (_, flags), members in targets.items():
        members.sort(key=lambda member: member["file"])
        chunk_count = -(-len(members) // BATCH_SIZE)
        for number in range(chunk_count):
            yield flags, members[number::chunk_count]


def commands_of(flags, members, path):
    """Returns one command for all sources that compile together, and one for each of the others."""
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
