"""A table that a class has computed, judged cell by cell; and the right one beside it. Needs pandas."""

import pandas as pd

import carom

students = pd.DataFrame(
    {
        "ratio": ["4", "4", "100", "100"],
        "e": ["1", "0.9", "0.9", "0.9"],
        "n": [0, 0, 1, 2],
        "eta": ["0.64", "0.58", "0.15", "0.1997"],
    }
)
cells = pd.DataFrame([vars(cell) for cell in carom.check_table(students)])
print(cells[["line", "written", "certified", "judgement"]].to_string(index=False))

table = carom.table(ratio="1:100:x10", e=["0.8", "0.9"], n="0:3:1").to_pandas()
print(table.head())
