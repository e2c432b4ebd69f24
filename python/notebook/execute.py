"""Executes the notebook: `execute.py` stores the outputs, `execute.py --check` compares them with those stored."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any, List

import nbformat
from nbclient import NotebookClient

PATH = Path(__file__).with_name("carom.ipynb")


def outputs(notebook: Any) -> List[Any]:
    """What the cells show; streams that came in pieces are joined."""
    found = []
    for cell in notebook.cells:
        if cell.cell_type != "code":
            continue
        shown: List[Any] = []
        for output in cell.outputs:
            if output.output_type == "stream" and shown and shown[-1][0] == output.name:
                shown[-1][1] += output.text
            elif output.output_type == "stream":
                shown.append([output.name, output.text])
            else:
                shown.append([output.output_type, dict(output.get("data", {})), output.get("evalue")])
        found.append([cell.source, shown])
    return found


def main() -> int:
    notebook = nbformat.read(PATH, as_version=4)
    stored = outputs(notebook)
    NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(PATH.parent)}}).execute()
    if "--check" in sys.argv:
        different = [i for i, (old, new) in enumerate(zip(stored, outputs(notebook))) if old != new]
        for i in different:
            print(f"cell {i + 1} shows something else now:\n{stored[i]}\n{outputs(notebook)[i]}", file=sys.stderr)
        print(f"{PATH.name}: {len(stored)} cells executed, {len(different)} differ")
        return 1 if different or not stored else 0
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
    nbformat.write(notebook, PATH)
    return 0


if __name__ == "__main__":
    sys.exit(main())
