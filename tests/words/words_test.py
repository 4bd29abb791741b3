#!/usr/bin/env python3
"""Keeps new words of the dialect out: counts the words of words.txt and compares with baseline.csv.

Counted are texts, which users read (string literals of C++ and of the report's JavaScript, Markdown without its code),
and comments, also those of vehicle files, studies and CMake. A literal of one word, such as "march", is a name and counts only for words that ask for names.

    words_test.py               fails where a count is above its baseline
    words_test.py --update      lowers the baseline to the counts and never raises it; writes it where there is none
    words_test.py --list WORD   prints the places of a word

Remedy for a failure: write the field's word, or give words.txt an exception with its reason.
"""
import argparse
import collections
import csv
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
BASELINE = HERE / "baseline.csv"
DOCUMENTS = ("*.md", "docs/**/*.md", "urdf/README.md", "meshes/README.md", "studies/**/README.md",
             "analysis/report/README.md", "tests/**/README.md")
# Versions that are out keep their words.
OLD = {"CHANGELOG.md"}
MARKED_UP = ("urdf/*.urdf", "studies/**/*.urdf")
CONFIGURED = ("studies/**/*.yaml", "cmake/*.cmake", "**/CMakeLists.txt")
CODE = ("analysis/**/*.cpp", "analysis/**/*.h", "analysis/report/web/**/*.js", "vehicles/**/*.cpp", "vehicles/**/*.h",
        "identify/**/*.cpp", "identify/**/*.h", "include/**/*.h")
SKIPPED = {"node_modules", "bundle", "build"}
NOT_PROSE = r"^```.*?^```|`[^`\n]*`|\]\([^)]*\)|<!--.*?-->"
TOKEN = re.compile(r"""(?P<comment>//[^\n]*|/\*.*?\*/)"""
                   r"""|R"(?P<tag>\w*)\(.*?\)(?P=tag)"|"(?:[^"\\\n]|\\.)*\""""
                   r"""|\d'(?=\d)|'(?:[^'\\\n]|\\.)*'|`(?:[^`\\]|\\.)*`""", re.S)

Word = collections.namedtuple("Word", "name layers pattern exceptions")
Place = collections.namedtuple("Place", "folder word kind file line")


def compiled(pattern):
    return re.compile(pattern.replace(" ", r"\s+"), re.I)


def read_words():
    """The words of words.txt, each with its exceptions."""
    lines = (HERE / "words.txt").read_text().splitlines()
    cells = [re.split(r" +\| ", line) for line in lines if line and not line.startswith("#")]
    allowed = collections.defaultdict(list)
    for row in cells:
        if row[0] == "allow":
            allowed[row[1]].append(compiled(row[2]))
    return [Word(row[1], row[2].split(), compiled(row[3]), allowed["*"] + allowed[row[1]])
            for row in cells if row[0] == "word"]


def blank(match):
    """White space in the place of a match, its lines kept."""
    return re.sub(r"[^\n]", " ", match.group())


def layers_of_code(text):
    """The file once for each kind of token, NUL in the place of all else: neighbours of a kind read as one sentence."""
    text = re.sub(r"^ *#include[^\n]*", blank, text, flags=re.M)
    layers = {kind: list(re.sub(r"\S", "\0", text)) for kind in ("text", "comment", "name")}
    for token in TOKEN.finditer(text):
        piece = token.group()
        if token["comment"]:
            kind, piece = "comment", re.sub(r"^\s*(?://+|/?\*+)", blank, piece, flags=re.M)
        else:
            inner = piece[1:-1]
            kind = "text" if re.search(r"\s", inner) else "name"
            piece = " " + re.sub(r"\\.", blank, inner, flags=re.S) + " "
        layers[kind][token.start():token.end()] = piece
    return {kind: "".join(layer) for kind, layer in layers.items()}


def layers_of_document(text):
    return {"text": re.sub(NOT_PROSE, blank, text, flags=re.S | re.M)}


def layers_of_markup(text):
    """Comments alone: names of vehicle files are the user's."""
    inside = re.sub(r"(?:\A|-->).*?(?:<!--|\Z)", blank, text, flags=re.S)
    return {"comment": inside}


def layers_of_configuration(text):
    """Comments from '#' to the end of the line."""
    return {"comment": re.sub(r"^[^#\n]*#?|(?<=\n)[^#\n]*$", blank, text, flags=re.M)}


def files():
    for patterns, layers in ((DOCUMENTS, layers_of_document), (CODE, layers_of_code), (MARKED_UP, layers_of_markup),
                             (CONFIGURED, layers_of_configuration)):
        for file in sorted(file for pattern in patterns for file in SOURCE.glob(pattern)):
            if not SKIPPED & set(file.relative_to(SOURCE).parts) and file.name not in OLD:
                yield file.relative_to(SOURCE), layers(file.read_text())


def places(words):
    """Each place of a word outside its exceptions."""
    for file, layers in files():
        for word in words:
            for kind in set(word.layers) & set(layers):
                layer = layers[kind]
                spans = [match.span() for exception in word.exceptions for match in exception.finditer(layer)]
                for match in word.pattern.finditer(layer):
                    if not any(begin <= match.start() and match.end() <= end for begin, end in spans):
                        line = layer.count("\n", 0, match.start()) + 1
                        yield Place(file.parts[0], word.name, kind.replace("name", "text"), file, line)


def list_places(word):
    for place in places([word]):
        text = (SOURCE / place.file).read_text().splitlines()[place.line - 1].strip()
        print(f"{place.file}:{place.line}: {place.kind}: {text}")


def read_baseline():
    with BASELINE.open(newline="") as file:
        return {(row["folder"], row["word"], row["kind"]): int(row["count"]) for row in csv.DictReader(file)}


def write_baseline(counts):
    with BASELINE.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["folder", "word", "kind", "count"])
        writer.writerows([*key, count] for key, count in sorted(counts.items()) if count)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--update", action="store_true", help="lower the baseline to the counts")
    parser.add_argument("--list", metavar="WORD", help="print the places of a word of words.txt")
    arguments = parser.parse_args()
    words = read_words()
    if arguments.list:
        chosen = [word for word in words if word.name == arguments.list]
        if not chosen:
            sys.exit(f"no word '{arguments.list}' in words.txt, which has: {', '.join(word.name for word in words)}")
        return list_places(chosen[0])
    counts = collections.Counter((place.folder, place.word, place.kind) for place in places(words))
    baseline = read_baseline() if BASELINE.exists() or not arguments.update else counts
    if arguments.update:
        write_baseline({key: min(count, counts[key]) for key, count in baseline.items()})
    above = [(*key, count, baseline.get(key, 0)) for key, count in sorted(counts.items()) if count > baseline.get(key, 0)]
    for folder, word, kind, count, limit in above:
        print(f"{folder}: '{word}' stands {count} times as {kind}, baseline {limit}; see --list '{word}'")
    sys.exit(1 if above else 0)


if __name__ == "__main__":
    main()
