"""What a unity build hides: each file of src brings what it names, itself or by way of what it includes. Types
and functions of plumbline that one header alone declares, and the names of the standard library's headers.
By names alone, in seconds, which finds about half of what scripts/alone does in a quarter of an hour."""

import functools
import pathlib
import re
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2] / "src"
INTERFACE = SOURCE.parent / "include/plumbline"
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]', re.M)
NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
TYPE = re.compile(r"^(?:struct|class|enum class|enum) (?:\[\[nodiscard\]\] )?(\w+)\b(?!;)|^using (\w+) =", re.M)
FUNCTION = re.compile(r"^(?:\[\[nodiscard\]\] |inline |constexpr |extern |template <[^\n]*>\s)*[\w:<>,*& ]+?[\w>*&] [*&]?(\w+)\([^\n]*[,;{(}]$", re.M)
OTHERWISE = [re.compile(pattern, re.M) for pattern in (  # what is not, or not only, a header's own
    r"^[ \t]+(?:struct|class|enum class|enum|using|namespace) (\w+)\b", r"\b(?:typename|class) (\w+)[,>=]",
    r"^[ \t]+(?!return\b|throw\b|else\b|new\b|case\b)[\w:<>,*& ]*?[\w>&*] [*&]?(\w+)\(", r"\b(\w+) = \[", r"\w::(\w+)\(",
    r"\bnamespace (\w+)\b", r"\bfriend \w+ (\w+);", r"& (\w+) =")]
OF_STANDARD = {  # the first that brings it will do
    "vector": ["vector"], "map": ["map"], "set": ["set"], "optional": ["optional"], "nullopt": ["optional"], "array": ["array"],
    "function": ["functional"], "unique_ptr": ["memory"], "shared_ptr": ["memory"], "make_unique": ["memory"],
    "make_shared": ["memory"], "span": ["span"], "deque": ["deque"], "list": ["list"], "variant": ["variant"],
    "mutex": ["mutex"], "lock_guard": ["mutex"], "thread": ["thread"], "jthread": ["thread"], "atomic": ["atomic"],
    "condition_variable": ["condition_variable"], "string_view": ["string_view", "string"], "string": ["string"],
    "unordered_map": ["unordered_map"], "sort": ["algorithm"], "find_if": ["algorithm"], "any_of": ["algorithm"],
    "all_of": ["algorithm"], "none_of": ["algorithm"], "accumulate": ["numeric"], "iota": ["numeric"], "sin": ["cmath"],
    "cos": ["cmath"], "sqrt": ["cmath"], "hypot": ["cmath"], "isfinite": ["cmath"], "floor": ["cmath"], "lround": ["cmath"],
    "numeric_limits": ["limits"], "from_chars": ["charconv"], "istringstream": ["sstream"], "ostringstream": ["sstream"],
    "runtime_error": ["stdexcept"], "mt19937_64": ["random"], "complex": ["complex"], "bit_cast": ["bit"],
}
OF_LIBRARIES = {"fmt::": "fmt/", "Eigen::": "Eigen/", "toml::": "toml++/", "nlohmann::": "nlohmann/", "CLI::": "CLI/"}


def brought(text):
    """The names that a header declares for others."""
    names = {a or b for a, b in TYPE.findall(text)} | set(FUNCTION.findall(text))
    return {name for name in names if len(name) > 3 and re.search("[A-Z_]", name)}


def main():
    files = {path.relative_to(SOURCE).as_posix(): path.read_text() for path in sorted(SOURCE.rglob("*.[hc]pp"))}
    code = {name: INCLUDE.sub("", NOT_CODE.sub(" ", text)) for name, text in files.items()}
    includes = {name: INCLUDE.findall(text) for name, text in files.items()}
    for path in INTERFACE.glob("*.h*"):
        includes[f"plumbline/{path.name}"] = INCLUDE.findall(path.read_text())

    @functools.lru_cache(maxsize=None)
    def reached(name):
        """All that a file includes, itself among it, by way of what it includes."""
        own, queue = {name}, [name]
        while queue:
            for path in includes.get(queue.pop(), ()):
                if path not in own:
                    own.add(path)
                    queue.append(path)
        return own

    declared = {}
    for name in files:
        if name.endswith(".hpp"):
            for symbol in brought(code[name]):
                declared.setdefault(symbol, set()).add(name)
    declared_otherwise = {symbol for text in code.values() for pattern in OTHERWISE for symbol in pattern.findall(text)}
    for path in INTERFACE.glob("*.h*"):
        declared_otherwise |= set(re.findall(r"\w+", path.read_text()))
    for name, text in code.items():
        if name.endswith(".cpp"):
            declared_otherwise |= brought(text) - brought(code.get(name[:-3] + "hpp", ""))
    once = {symbol: headers.pop() for symbol, headers in declared.items()
            if len(headers) == 1 and symbol not in declared_otherwise}

    wrong, looked = [], 0
    for name, text in code.items():
        if "platform/windows" in name:
            continue
        own = reached(name)
        here = brought(text) | set(re.findall(r"^(?:struct|class|enum class) (\w+);", text, re.M))
        for match in set(re.findall(r"(?<![.\w>:])(?:\w+::)*([A-Z]\w+|\w+(?=\())", text)):
            header = once.get(match)
            if header is None or header == name or match in here or header in own:
                looked += header is not None
                continue
            wrong.append(f"{name}: {match} is of {header}, which it does not include")
        for match in set(re.findall(r"\bstd::(\w+)", text)) & set(OF_STANDARD):
            looked += 1
            if not own & set(OF_STANDARD[match]):
                wrong.append(f"{name}: std::{match} is of <{OF_STANDARD[match][0]}>, which it does not include")
        for prefix, headers in OF_LIBRARIES.items():
            if re.search(rf"(?<![\w:]){prefix}", text):
                looked += 1
                if not any(header.startswith(headers) for header in own):
                    wrong.append(f"{name}: {prefix} is of {headers}, of which it includes nothing")
    assert looked > 5000, looked
    print(*wrong, f"{len(files)} files, {looked} names", sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
