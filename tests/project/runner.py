"""A model of GitHub's runner, as far as the jobs of this project need it.

Steps with commands are run in bash as the service runs them, with its variables.  So are the steps
of this project's own action; other actions are noted, and not run.  An expression or a condition
that is not known here is an error; it never counts as true.
"""

import os
import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

from ruamel.yaml import YAML

ROOT = Path(__file__).parents[2]
OURS = "OWNER/allworlds@REF"


def read(path):
    """A YAML file as dicts and lists."""
    return YAML(typ="safe", pure=True).load(Path(path).read_text(encoding="utf-8"))


@dataclass
class Job:
    """A job in the course of its steps."""

    workspace: Path
    environment: dict
    failed: bool = False
    outputs: dict = field(default_factory=dict)
    used: list = field(default_factory=list)
    log: str = ""

    @property
    def summary(self):
        return Path(self.environment["GITHUB_STEP_SUMMARY"]).read_text(encoding="utf-8")

    def run(self, steps, inputs=None):
        """The steps, in order; what an action's steps put out is told by its own name."""
        told = {}
        for step in steps:
            if not self.is_due(step.get("if", "success()"), inputs or {}):
                continue
            if "run" in step:
                told[step.get("id")] = self.command(step, inputs or {}, told)
            elif step["uses"] == OURS:
                self.action(step)
            else:
                self.used.append(step)

    def is_due(self, condition, inputs):
        match re.fullmatch(r"inputs\.([\w-]+) != ''", condition):
            case re.Match() as found:
                return not self.failed and inputs[found[1]] != ""
        return {"success()": not self.failed, "failure()": self.failed, "always()": True}[condition]

    def action(self, step):
        described = read(ROOT / "action.yml")
        given = {name: str(value) for name, value in step.get("with", {}).items()}
        assert set(given) <= set(described["inputs"])
        defaults = {name: one["default"] for name, one in described["inputs"].items()}
        self.run(described["runs"]["steps"], {**defaults, **given})

    def command(self, step, inputs, told):
        output = self.workspace.parent / f"output-{len(self.log)}"
        output.touch()
        env = {name: filled(value, inputs, told) for name, value in step.get("env", {}).items()}
        assert "${{" not in step["run"], "what is given goes through the environment alone"
        done = subprocess.run(
            ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]],
            cwd=self.workspace,
            env={**self.environment, **env, "GITHUB_OUTPUT": str(output)},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            timeout=300,
            check=False,
        )
        self.log += done.stdout
        self.failed = self.failed or done.returncode != 0
        lines = output.read_text(encoding="utf-8").splitlines()
        self.outputs |= dict(line.split("=", 1) for line in lines)
        return self.outputs


def filled(text, inputs, told):
    """The text with the values of its expressions."""

    def value(found):
        match found[1].strip().split("."):
            case ["inputs", name]:
                return inputs[name]
            case ["github", "action_path"]:
                return str(ROOT)
            case ["steps", step, "outputs", name]:
                return told[step][name]
        raise AssertionError(found[0])

    return re.sub(r"\$\{\{(.*?)\}\}", value, text)


def job_in(workspace, programs):
    """A job in a folder, whose programs come from another one first."""
    summary = workspace.parent / "summary.md"
    summary.touch()
    environment = {
        **os.environ,
        "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}",
        "GITHUB_ACTIONS": "true",
        "GITHUB_STEP_SUMMARY": str(summary),
        "GITHUB_WORKSPACE": str(workspace),
        "RUNNER_TEMP": str(workspace.parent),
    }
    environment.pop("COLUMNS", None)
    return Job(workspace, environment)
