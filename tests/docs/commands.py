"""commands.py TENCER SCENE_PAGE PAGE...

What pages say of the program's commands is so: every command and option that they name is there, as
`tencer COMMAND ... --option` or as `--option` alone; every command is on some page; and the families
of curves have the parameters that the page of scenes says.
"""

import pathlib
import re
import subprocess
import sys


def help_of(tencer, *command):
    done = subprocess.run([tencer, *command, "--help"], capture_output=True, text=True, check=True)
    return done.stdout


def commands_in(text):
    """The names of commands that a help lists."""
    listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.M)
    return re.findall(r"^  ([\w-]+)", listed[1], re.M) if listed else []


def options_in(text):
    return set(re.findall(r"(?<![\w-])--?[a-z][\w-]*", text))


def said(page):
    """(command or nothing, option) of a page."""
    text = page.read_text()
    fenced = "".join(re.findall(r"^```\w+\n(.*?)^```", text, re.M | re.S))
    indented = "\n".join(re.findall(r"^ {4}(.*)$", text, re.M))
    for line in re.findall(r"^(?:\$ )?(tencer [a-z].*)$", f"{fenced}\n{indented}", re.M):
        yield from used(line.partition("  #")[0])
    for span in re.findall(r"`([^`]+)`", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)):
        if span.startswith("tencer "):
            yield from used(span)
        elif re.match(r"--[a-z]", span):
            yield "", re.match(r"--[\w-]+", span)[0]


def used(line):
    words = line.split("|")[0].split()
    command = words[1] if len(words) > 1 else ""
    yield command, ""
    for word in words[2:]:
        if re.match(r"--[a-z]", word):
            yield command, re.match(r"--[\w-]+", word)[0]


def families(page):
    """{family: {parameter: default}} of the table of scenes."""
    table = re.search(r"^\| family .*\n\|[-|]+\n((?:\|.*\n)+)", page.read_text(), re.M)[1]
    for row in table.splitlines():
        names, parameters = row.strip().strip("|").split("|")
        names = [f"knot-{name}" if name[0].isdigit() else name
                 for name in re.findall(r"`([^`]+)`", names) if name != "knot-"]
        yield names, re.findall(r"`(\w+)` \(([\d.]+)\)", parameters)


def main():
    tencer, scene_page, *pages = map(pathlib.Path, sys.argv[1:])
    top = help_of(tencer)
    options = {"": options_in(top)}
    for command in commands_in(top):
        text = help_of(tencer, command)
        parts = [text, *(help_of(tencer, command, part) for part in commands_in(text)), top]
        options[command] = set().union(*map(options_in, parts))
    everything = set().union(*options.values())
    faults, named = [], set()
    for page in pages:
        for command, option in said(page):
            named.add(command)
            if command.isupper() or command.startswith("-"):
                continue  # "tencer COMMAND --help"
            if command not in options:
                faults.append(f"{page}: there is no command '{command}'")
            elif option and option not in (options[command] if command else everything):
                faults.append(f"{page}: tencer {command} has no option {option}")
    faults += [f"no page has the command {command}" for command in options.keys() - named - {""}]
    for names, parameters in families(scene_page):
        for family in names:
            text = help_of(tencer, "target", family)
            for parameter, standard in parameters:
                if not re.search(rf"--{parameter.replace('_', '-')} .*={standard}\b", text):
                    faults.append(f"{scene_page}: {family}: no {parameter} of {standard} in {text}")
    sys.exit("\n".join(faults) or 0)


main()
