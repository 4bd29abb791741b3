"""What the coverage studies share."""
import subprocess
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]


def run(*arguments):
    """Of the program; codes 0 and 1, a model that does not explain its data, are results."""
    outcome = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    if outcome.returncode not in (0, 1):
        raise RuntimeError(" ".join(map(str, arguments)) + "\n" + outcome.stderr[-2000:])
    return outcome
