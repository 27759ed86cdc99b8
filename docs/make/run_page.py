"""run_page.py [--write] PAGE TENCER WORK

Follows a page word by word in the empty folder WORK, with the program TENCER, and fails where the
page shows something else than what comes out; with --write the page gets what comes out. On a page

- a fenced block whose first line is a comment that names a file, "# sketch.toml", is that file;
- in a `console` block, "$ COMMAND" is followed by all that it prints, but for lines that tell seconds,
  or by the first lines of that and "...";
- in an `sh` block lines that begin with `tencer` are run, and what they print is not shown. Searches
  in them end after a fraction of a second: what counts is that the page's commands are right;
- `<!-- picture: FILE -->` says what the picture below it shows: an SVG, or a page of a PDF
  (`FILE.pdf 1`), which becomes a PNG.

Words and names have to be the same, and numbers up to 3 %: another machine rounds otherwise.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).parents[2]
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)
PICTURE = re.compile(r'^<!-- picture: (\S+)(?: (\d+))? -->\n.*?(?:\(|src=")([^)"]+)', re.M)
NUMBER = re.compile(r"-?\d+\.?\d*(?:e[-+]?\d+)?")
SECONDS = re.compile(r"(^|[,;] )[0-9.e+-]+ s(;| in all|$)")
ROUNDING = 1e-6  # what is smaller differs from machine to machine
QUICKLY = "--time 0.2 --resolution 0.5 --length-error 0 --attachment-error 0"


class Page:
    def __init__(self, path, tencer, work):
        self.path, self.work = path, work
        self.faults, self.commands, self.pictures = [], 0, 0
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        (work / "examples").symlink_to(ROOT / "examples")
        (work / "bin").mkdir()
        (work / "bin" / "tencer").symlink_to(tencer.resolve())
        self.environment = {**os.environ, "PATH": f"{work / 'bin'}:{os.environ['PATH']}"}

    def run(self, command):
        """All that it prints, but for lines that tell seconds."""
        self.commands += 1
        done = subprocess.run(["bash", "-c", command], cwd=self.work, env=self.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode not in (0, 3):  # complete, or not
            sys.exit(f"{self.path}: {command}: exit code {done.returncode}: {done.stdout}")
        lines = done.stdout.splitlines()
        return "".join(f"{line}\n" for line in lines if not SECONDS.search(line))

    def block(self, kind, text):
        """Follows a block; the text that it should have."""
        named = re.match(r"# ([\w-]+\.\w+)\b", text)
        if named:
            (self.work / named[1]).write_text(text)
        elif kind == "console":
            sessions = re.findall(r"^\$ (.+)\n((?:(?!\$ ).*\n)*)", text, re.M)
            return "".join(f"$ {command}\n{cut(self.run(command), shown)}"
                           for command, shown in sessions)
        elif kind == "sh":
            for command in re.findall(r"^tencer .+$", text, re.M):
                words = command.partition("  #")[0]
                self.run(f"{words} {QUICKLY}" if words.startswith("tencer design") else words)
        return text

    def picture(self, source, number, target):
        """Draws a picture of the page; fails where the page has another one."""
        self.pictures += 1
        file, kept = self.work / source, self.path.parent / target
        if number:
            png = self.work / kept.name
            subprocess.run(["pdftoppm", "-png", "-singlefile", "-r", "70", "-f", number, "-l", number,
                            file, png.with_suffix("")], check=True)
            return png, kept, kept.exists()  # as a whole it depends on fonts
        # What it shows stands in its title; where words go in it depends on fonts.
        return file, kept, kept.exists() and title(kept.read_text()) == title(file.read_text())


def title(svg):
    return re.search(r"<title>(.*?)</title>", svg)[1]


def cut(printed, shown):
    """As much of what is printed as is shown, where that ends with "..."."""
    lines = shown.splitlines()
    if lines[-1:] != ["..."]:
        return printed
    return "\n".join([*printed.splitlines()[:len(lines) - 1], "...", ""])


def same(shown, found):
    """Whether two texts are the same but for blanks, and numbers up to 3 %."""
    if NUMBER.sub("#", shown).split() != NUMBER.sub("#", found).split():
        return False
    for one, other in zip(NUMBER.findall(shown), NUMBER.findall(found)):
        a, b = float(one), float(other)
        digits = 10.0 ** -len(one.partition(".")[2]) if "." in one and "e" not in one else 0
        allowed = max(0.03 * max(abs(a), abs(b)), digits, ROUNDING)
        if abs(a - b) > 1.001 * allowed:
            return False
    return True


def main():
    write = "--write" in sys.argv
    path, tencer, work = map(pathlib.Path, [word for word in sys.argv[1:] if word != "--write"])
    page = Page(path.resolve(), tencer, work.resolve())
    text = path.read_text()
    made, at = "", 0
    for block in BLOCK.finditer(text):
        follows = page.block(block[1], block[2])
        if not same(block[2], follows):
            page.faults.append(f"shows\n{block[2]}but what comes out is\n{follows}")
        else:
            follows = block[2]
        made += text[at:block.start(2)] + follows
        at = block.end(2)
    made += text[at:]
    for source, number, target in PICTURE.findall(text):
        new, kept, current = page.picture(source, number, target)
        if write and (number or not current):
            shutil.copy(new, kept)
        elif not current:
            page.faults.append(f"{target} is not what is in {new}")
    if write:
        path.write_text(made)
    elif page.faults:
        sys.exit(f"{path}: " + f"\n{path}: ".join(page.faults) +
                 f"\nTo mend the page: python3 docs/make/run_page.py --write {path} TENCER WORK")
    print(f"{path}: {page.commands} commands, {page.pictures} pictures")


main()
