"""The commands as the shells see them: those of `tolman help-tree`, with the options that every command has."""


class Command:
    """One command: what may follow it."""

    def __init__(self, node, common):
        self.words = node["words"]
        self.name = node["name"]
        self.text = node["text"]
        self.options = node["options"] + common
        self.positionals = node["positionals"]
        self.commands = [Command(child, common) for child in node["commands"]]

    @staticmethod
    def root(node):
        """The program itself. `help` is followed by the same commands, without anything else."""
        root = Command(node, [])
        root.commands = [Command(child, common_options(node)) for child in node["commands"]]
        for command in root.commands:
            if command.name == "help":
                command.commands = bare(node["commands"], command.words)
                command.positionals = []
        return root

    def all(self):
        """This command and all below it."""
        return [self] + [command for child in self.commands for command in child.all()]


def common_options(root):
    """The program's options that can stand behind every command."""
    return [option for option in root["options"] if not {"--help", "--version"} & set(option["names"])]


def bare(nodes, words):
    """Commands behind `words`, with their names and texts only."""
    commands = []
    for node in nodes:
        behind = f"{words} {node['name']}"
        command = Command({**node, "words": behind, "options": [], "positionals": [], "commands": []}, [])
        command.commands = bare(node["commands"], behind)
        commands.append(command)
    return commands


def value_of(part):
    """What a shell offers for the value of an option or an argument: a kind, with its choices or its role."""
    if part["kind"] == "choice":
        return "choice " + " ".join(part["choices"])
    return part["kind"] or "anything"
