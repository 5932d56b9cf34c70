#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""make.py: writes the workbooks of points_workbook_test.cpp with openpyxl and XlsxWriter (Debian:
python3-openpyxl 3.0.9, python3-xlsxwriter 3.0.2), which share no code with Jounce."""
import datetime
import os

import openpyxl
import xlsxwriter

folder = os.path.dirname(os.path.abspath(__file__))


def cam_of_a_colleague():
    """One sheet as people make it: a title, names of Siemens, signs of units, a remark at the side, an empty row,
    and numbers that were typed as text."""
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.title = "Nocken 7"
    sheet["A1"] = "Kurve Station 7, Stand 12.3."
    for column, name in enumerate(["Leitwert [°]", "Folgewert (µm)", "tol / µm"], start=2):
        sheet.cell(3, column, name)
    rows = [(0, 0, 5), (90, 12500.25, 5), None, ("180,5", "25000", 5), (270, 12500.25, 5), (360, 0, 5)]
    for row, values in enumerate(rows, start=4):
        for column, value in enumerate(values or (), start=2):
            sheet.cell(row, column, value)
    sheet["G5"] = "hier war es laut"
    book.create_sheet("Notizen")["A1"] = "nur Text"
    book.save(os.path.join(folder, "colleague.xlsx"))


def measured():
    """A first sheet without cells; units in a row of their own; formulas with their results; inline texts."""
    book = xlsxwriter.Workbook(os.path.join(folder, "measured.xlsx"), {"in_memory": True})
    book.set_properties({"created": datetime.datetime(2026, 1, 1)})
    book.add_worksheet("Plot")
    sheet = book.add_worksheet("Data")
    for column, (name, unit) in enumerate([("Time", "ms"), ("Position", "mm"), ("Velocity", "mm/s²")]):
        sheet.write(0, column, name)
        sheet.write(1, column, unit if name != "Velocity" else "mm/s")
    for row in range(5):
        sheet.write_formula(2 + row, 0, f"=10*ROW(A{row + 1})-10", None, 10 * row)
        sheet.write_number(2 + row, 1, 0.1 * row)
        sheet.write_rich_string(2 + row, 3, "as ", book.add_format({"bold": True}), "seen", " by eye")
        sheet.write_number(2 + row, 2, 10)
    book.close()


def mistakes():
    """One mistake in each sheet."""
    book = xlsxwriter.Workbook(os.path.join(folder, "mistakes.xlsx"), {"in_memory": True})
    book.set_properties({"created": datetime.datetime(2026, 1, 1)})
    date = book.add_format({"num_format": "[$-407]hh:mm:ss;@"})
    red = book.add_format({"num_format": '[Red]0.00 "dm"'})

    def sheet_of(name, cell, write):
        sheet = book.add_worksheet(name)
        for row, values in enumerate([("time [s]", "position [mm]"), (0, 0), (1, 2.5), (2, 0)]):
            for column, value in enumerate(values):
                sheet.write(row, column, value)
        write(sheet, cell)

    sheet_of("good", "B3", lambda sheet, cell: sheet.write_number(cell, 2.5, red))
    sheet_of("date", "A3", lambda sheet, cell: sheet.write_number(cell, 0.5, date))
    sheet_of("error", "B3", lambda sheet, cell: sheet.write_formula(cell, "=1/0", None, "#DIV/0!"))
    sheet_of("text", "B3", lambda sheet, cell: sheet.write_string(cell, "about 3"))
    sheet_of("empty", "B3", lambda sheet, cell: sheet.write_blank(cell, None, red))
    sheet_of("formula", "B3", lambda sheet, cell: sheet.write_formula(cell, "=A3*2", None, ""))
    sheet_of("twice", "B1", lambda sheet, cell: sheet.write_string(cell, "time [s]"))
    sheet_of("unit", "B1", lambda sheet, cell: sheet.write_string(cell, "position [furlong]"))
    sheet_of("mixed", "B2", lambda sheet, cell: (sheet.write_string(cell, "1,5"), sheet.write_string("B3", "1.5")))
    sheet = book.add_worksheet("headless")
    for row in range(3):
        sheet.write_number(row, 0, row)
        sheet.write_number(row, 1, row)
    book.close()


def example():
    """The points of examples/points-file/points.csv."""
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.title = "Points"
    for row in (("time [ms]", "position [cm]"), (0, 0), (100, 0), (250, 0.8), (500, 2.75), (750, 5.1), (1000, 5.6),
                (1250, 5.6)):
        sheet.append(row)
    book.save(os.path.join(folder, "../../../examples/points-file/points.xlsx"))


cam_of_a_colleague()
example()
measured()
mistakes()
