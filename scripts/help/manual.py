"""Manual pages: tolman.1 and one for each command, tolman-run.1, tolman-plugins-new.1 ..."""
from help.tree import common_options

HEAD = r""".\" Generated from the program's help by scripts/generate-help
"""


def escaped(text):
    """Text as roff reads it: hyphens that can be copied, and no line that begins as a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("~", "\\(ti").replace("^", "\\(ha")
    return "\\&" + text if text[:1] in (".", "'") else text


def page_of(node):
    """The name of a command's page."""
    return node["words"].replace(" ", "-")


def section(title, lines):
    """A section, or nothing where it would be empty."""
    return [f".SH {title}"] + lines if lines else []


def item(term, text):
    """A term with its text below."""
    return [".TP", term, escaped(text)]


def value_name(part):
    """The value of an option or an argument, as it is typed: its choices, or a name."""
    if part.get("choices") and "|" in part["value"]:
        return "\\fB" + "\\fR|\\fB".join(escaped(choice) for choice in part["choices"]) + "\\fR"
    return f"\\fI{escaped(part['value'])}\\fR"


def option_lines(options):
    """Options with their values, defaults and choices."""
    lines = []
    for option in options:
        term = ", ".join(f"\\fB{escaped(name)}\\fR" for name in option["names"])
        text = option["text"].rstrip(".") + "."
        if "value" in option:
            term += " " + value_name(option)
            if option.get("choices") and "|" not in option["value"]:
                text += " One of " + ", ".join(option["choices"]) + "."
            if option.get("default"):
                text += f" Default: {option['default']}."
            if option["required"]:
                text += " Required."
        lines += item(term, text)
    return lines


def argument_lines(node):
    """Positional arguments."""
    return [line for part in node["positionals"]
            for line in item(f"\\fI{escaped(part['name'])}\\fR" + (" ..." if part["repeated"] else ""),
                             part["text"].rstrip(".") + "." +
                             (f" One of {', '.join(part['choices'])}." if part.get("choices") else ""))]


def command_lines(node):
    """The commands below, with the names of their pages."""
    return [line for child in node["commands"]
            for line in item(f"\\fB{escaped(child['words'])}\\fR", f"{child['text'].rstrip('.')}. See {page_of(child)}(1).")
            + command_lines(child)]


def example_lines(node):
    """Examples, each with its purpose."""
    lines = []
    for example in node["examples"]:
        if example["purpose"]:
            lines += [".PP", escaped(example["purpose"][0].upper() + example["purpose"][1:]) + ":"]
        lines += [".PP", ".nf", ".RS", escaped(example["command"]), ".RE", ".fi"]
    return lines[1:]  # a section is a paragraph already


def synopsis(node):
    """The ways to call a command."""
    calls = []
    if not node["commands"] or node["positionals"]:
        words = ["\\fI" + escaped(part["name"]) + "\\fR" + (" ..." if part["repeated"] else "")
                 for part in node["positionals"]]
        words = [word if part["required"] else f"[{word}]" for word, part in zip(words, node["positionals"])]
        required = [f"\\fB{escaped(option['names'][-1])}\\fR {value_name(option)}"
                    for option in node["options"] if option.get("required")]
        calls.append(" ".join([f"\\fB{escaped(node['words'])}\\fR"] + words + required + ["[\\fIOPTIONS\\fR]"]))
    if node["commands"]:
        calls.append(f"\\fB{escaped(node['words'])}\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]")
    return [line for call in calls for line in (call, ".br")][:-1]


def page(node, tree, date, parent):
    """The text of one page."""
    related = ([parent] if parent else []) + node["commands"] if parent else node["commands"]
    exits = [line for code in tree["exit_codes"] for line in item(f"\\fB{code['code']}\\fR", code["meaning"])]
    lines = [f".TH {escaped(page_of(node).upper())} 1 {date} \"Tolman {tree['version']}\" Tolman", ".nh", ".ad l"]
    lines += section("NAME", [f"{escaped(page_of(node))} \\- {escaped(node['text'].removeprefix('Tolman: ').rstrip('.'))}"])
    lines += section("SYNOPSIS", synopsis(node))
    lines += section("ARGUMENTS", argument_lines(node))
    lines += section("COMMANDS", command_lines(node))
    lines += section("OPTIONS", option_lines(node["options"]))
    if parent:
        lines += section('"OPTIONS OF ALL COMMANDS"', option_lines(common_options(tree["command"])))
    lines += section("EXAMPLES", example_lines(node))
    lines += section('"EXIT STATUS"', exits)
    lines += section('"SEE ALSO"', [",\n".join(f"\\fB{escaped(page_of(other))}\\fR(1)" for other in related)])
    return HEAD + "\n".join(lines) + "\n"


def pages(tree, date):
    """All pages, by the file below share/."""
    def below(node, parent):
        found = {f"man/man1/{page_of(node)}.1": page(node, tree, date, parent)}
        for child in node["commands"]:
            found.update(below(child, node))
        return found

    return below(tree["command"], None)
