#!/usr/bin/env python3
"""command_pages.py DESCRIPTION OUT: manual pages and completions of bash, zsh and fish, made of what
`plumbline --description` says of the command line (src/cli/description.hpp)."""
import json
import sys
from pathlib import Path

FILES = ("FILE", "MODEL", "DATASET", "DIR", "FOLDER", "FILE.html", "PROGRAM", "MODEL2")


def roff(text):
    """Text as it stands, for troff."""
    lines = text.replace("\\", "\\e").replace("-", "\\-").split("\n")
    return "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in lines)


def usage_of(command):
    words = [positional["name"] if positional["required"] else f"[{positional['name']}]"
             for positional in command["positionals"]]
    return " ".join(["[OPTIONS]", *words])


def entries(options):
    out = []
    for option in options:
        value = f" \\fI{roff(option['value'])}\\fR" if option["takes_value"] and option["value"] not in ("", option["name"]) else ""
        names = ", ".join(f"\\fB{roff(name)}\\fR" for name in option["names"]) or f"\\fI{roff(option['name'])}\\fR"
        more = ("; required" if option["required"] and option["names"] else "") + (
            f"; one of {', '.join(option['choices'])}" if option["choices"] else "")
        out.append(f".TP\n{names}{value}\n{roff(option['for'] + more)}")
    return out


def manual(program, command=None):
    subject = command or program
    name = program["name"] + (f"-{command['name']}" if command else "")
    called = program["name"] + (f" {command['name']}" if command else "")
    lines = [f'.TH {name.upper().replace("-", chr(92) + "-")} 1 "" "{program["name"]} {program["version"]}"', ".SH NAME",
             f"{roff(name)} \\- {roff(subject['for'])}", ".SH SYNOPSIS",
             f"\\fB{roff(called)}\\fR {roff(usage_of(subject) if command else '[OPTIONS] COMMAND')}"]
    if subject["positionals"]:
        lines += [".SH ARGUMENTS", *entries(subject["positionals"])]
    lines += [".SH OPTIONS", *entries(subject["options"])]
    if not command:
        for group in dict.fromkeys(one["group"] for one in program["commands"]):
            lines.append(f".SH {roff(group).upper()}")
            for one in program["commands"]:
                if one["group"] == group:
                    lines.append(f".TP\n\\fB{roff(program['name'])}\\-{roff(one['name'])}\\fR(1)\n{roff(one['for'])}")
    lines += [".SH NOTES", ".nf", roff(subject["footer"]), ".fi"]
    if command:
        lines += [".SH SEE ALSO", f"\\fB{roff(program['name'])}\\fR(1)"]
    return "\n".join(lines) + "\n"


def names_of(options):
    return [name for option in options for name in option["names"]]


def bash(program):
    commands = " ".join(one["name"] for one in program["commands"])
    cases, values = [], {}
    for one in program["commands"]:
        cases.append(f"    {one['name']}) options='{' '.join(names_of(one['options']))}' ;;")
        for option in one["options"]:
            if option["takes_value"]:
                for name in option["names"]:
                    values.setdefault((one["name"], name), option["choices"])
    chosen = [f"    '{command} {name}') COMPREPLY=($(compgen -W '{' '.join(choices)}' -- \"$word\")); return ;;"
              for (command, name), choices in values.items() if choices]
    return f"""# bash completion of {program['name']}; made of its own options.
_{program['name']}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command= options= i
  for ((i = 1; i < COMP_CWORD; i++)); do
    case ${{COMP_WORDS[i]}} in -*) ;; *) command=${{COMP_WORDS[i]}}; break ;; esac
  done
  if [[ -z $command ]]; then
    COMPREPLY=($(compgen -W '{commands} {' '.join(names_of(program['options']))}' -- "$word"))
    return
  fi
  case "$command $before" in
{chr(10).join(chosen)}
  esac
  case $command in
{chr(10).join(cases)}
  esac
  [[ $word == -* ]] && COMPREPLY=($(compgen -W "$options" -- "$word"))
}}
complete -o default -F _{program['name']} {program['name']}
"""


def quoted(text):
    return text.replace("'", "'\\''")


def zsh_text(text):
    for special in "\\[]:":
        text = text.replace(special, "\\" + special)
    return quoted(text)


def zsh(program):
    def specification(option):
        value = ""
        if option["takes_value"]:
            choices = f"({' '.join(option['choices'])})" if option["choices"] else "_files" if option["value"].split(
                " ")[0] in FILES else " "
            value = f":{zsh_text(option['value'] or 'value')}:{choices}"
        return [f"      '*{name}[{zsh_text(option['for'])}]{value}'" for name in option["names"]]

    commands = "\n".join(f"    '{one['name']}:{zsh_text(one['for'])}'" for one in program["commands"])
    cases = []
    for one in program["commands"]:
        lines = [line for option in one["options"] for line in specification(option)]
        cases.append(f"    {one['name']})\n      _arguments \\\n" + " \\\n".join([*lines, "      '*:file:_files'"]) + " ;;")
    whole = [line.strip() for option in program["options"] for line in specification(option)]
    return f"""#compdef {program['name']}
# zsh completion of {program['name']}; made of its own options.
local -a commands
commands=(
{commands}
)
if (( CURRENT == 2 )); then
  _describe command commands
  _arguments {' '.join(whole)}
  return
fi
local command=$words[2]
shift words
(( CURRENT-- ))
case $command in
{chr(10).join(cases)}
esac
"""


def fish(program):
    name = program["name"]
    lines = [f"# fish completion of {name}; made of its own options."]

    def option_line(option, condition):
        parts = [f"complete -c {name}{condition}"]
        for one in option["names"]:
            parts.append(f"-l {one[2:]}" if one.startswith("--") else f"-s {one[1:]}")
        if option["takes_value"]:
            parts.append("-x -a '" + " ".join(option["choices"]) + "'" if option["choices"] else "-r")
        return " ".join([*parts, f"-d '{quoted(option['for'])}'"])

    for option in program["options"]:
        lines.append(option_line(option, " -n __fish_use_subcommand"))
    for one in program["commands"]:
        lines.append(f"complete -c {name} -n __fish_use_subcommand -f -a {one['name']} -d '{quoted(one['for'])}'")
        for option in one["options"]:
            lines.append(option_line(option, f" -n '__fish_seen_subcommand_from {one['name']}'"))
    return "\n".join(lines) + "\n"


def main(description, out):
    program = json.loads(Path(description).read_text())
    out = Path(out)
    pages = {f"man1/{program['name']}.1": manual(program), f"bash/{program['name']}": bash(program),
             f"zsh/_{program['name']}": zsh(program), f"fish/{program['name']}.fish": fish(program)}
    for command in program["commands"]:
        pages[f"man1/{program['name']}-{command['name']}.1"] = manual(program, command)
    for name, text in pages.items():
        path = out / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
