# SPDX-License-Identifier: Apache-2.0
"""Plots and tables of the report page: HTML and SVG as text, colours from its style sheet."""
from __future__ import annotations

import math
from dataclasses import dataclass
from html import escape
from typing import Sequence

NAME, WIDTH, ROW = 150, 300, 24  # a bar's name, its longest length, its line
PARTS = 9  # colours of a stack


@dataclass(frozen=True)
class Bar:
    """One value, and the range over its seeds."""

    name: str
    value: float
    low: float | None = None
    high: float | None = None
    other: bool = False  # not ours: in another colour


@dataclass(frozen=True)
class Range:
    """What was measured, within its bounds."""

    name: str
    low: float
    high: float
    bound_low: float
    bound_high: float


def number(value: float) -> str:
    """As many digits as one reads."""
    if value >= 100:
        return f"{value:,.0f}".replace(",", " ")
    return f"{value:.1f}" if value >= 10 else f"{value:.2f}".rstrip("0").rstrip(".")


def svg(width: int, height: int, label: str, parts: Sequence[str]) -> str:
    return (f'<svg viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" aria-label="{escape(label)}">'
            + "".join(parts) + "</svg>")


def bars(rows: Sequence[Bar], unit: str, logarithmic: bool = False) -> str:
    """Horizontal bars with their numbers."""
    if not rows:
        return ""
    most = max(bar.high or bar.value for bar in rows)
    least = min(bar.value for bar in rows)
    base = 10 ** math.floor(math.log10(least)) if logarithmic else 0

    def x(value: float) -> float:
        if logarithmic:
            return WIDTH * math.log10(value / base) / math.log10(most / base)
        return WIDTH * value / most

    parts = []
    for i, bar in enumerate(rows):
        y = i * ROW
        name = "theirs" if bar.other else "ours"
        parts.append(f'<text x="{NAME - 8}" y="{y + 16}" class="name">{escape(bar.name)}</text>'
                     f'<rect x="{NAME}" y="{y + 4}" width="{max(1, x(bar.value)):.1f}" height="{ROW - 8}" class="{name}"/>')
        end = x(bar.high or bar.value)
        if bar.low is not None and bar.high is not None:
            parts.append(f'<path d="M{NAME + x(bar.low):.1f} {y + 12}H{NAME + end:.1f}m0 -4v8M{NAME + x(bar.low):.1f} {y + 8}v8" class="range"/>')
        parts.append(f'<text x="{NAME + end + 6:.1f}" y="{y + 16}">{number(bar.value)} {escape(unit)}</text>')
    return svg(NAME + WIDTH + 100, len(rows) * ROW + 4, f"bars, {unit}", parts)


def ranges(rows: Sequence[Range]) -> str:
    """Measured ranges in the frames of their bounds."""
    if not rows:
        return ""
    name, width = 260, 560
    most = max(row.bound_high for row in rows)
    parts = []
    for i, row in enumerate(rows):
        y = i * ROW

        def x(value: float) -> float:
            return name + width * value / most

        parts.append(f'<text x="{name - 8}" y="{y + 16}" class="name">{escape(row.name)}</text>'
                     f'<rect x="{x(row.bound_low):.1f}" y="{y + 3}" width="{x(row.bound_high) - x(row.bound_low):.1f}" height="{ROW - 6}" class="bound"/>'
                     f'<rect x="{x(row.low):.1f}" y="{y + 7}" width="{max(1, x(row.high) - x(row.low)):.1f}" height="{ROW - 14}" class="ours"/>'
                     f'<text x="{x(row.bound_high) + 6:.1f}" y="{y + 16}">{number(row.bound_high)}</text>')
    return svg(name + width + 70, len(rows) * ROW + 4, "measured ranges and their bounds", parts)


def stacks(rows: Sequence[tuple[str, dict[str, int]]]) -> str:
    """Bars of parts, with one legend."""
    names = list(dict.fromkeys(name for _, parts in rows for name in parts))
    colour = {name: i % PARTS for i, name in enumerate(names)}
    most = max(sum(parts.values()) for _, parts in rows)
    name, width = 220, 620
    drawn = []
    for i, (title, parts) in enumerate(rows):
        y, at = i * 34, float(name)
        drawn.append(f'<text x="{name - 8}" y="{y + 20}" class="name">{escape(title)}</text>')
        for part, value in parts.items():
            length = width * value / most
            drawn.append(f'<rect x="{at:.1f}" y="{y + 4}" width="{length:.1f}" height="24" class="part{colour[part]}"><title>{escape(part)}: {value}</title></rect>')
            at += length
        drawn.append(f'<text x="{at + 6:.1f}" y="{y + 20}">{number(sum(parts.values()))}</text>')
    legend = "".join(f'<span><i class="part{colour[part]}"></i>{escape(part)}</span>' for part in names)
    return svg(name + width + 80, len(rows) * 34 + 4, "LUTs by part", drawn) + f'<p class="legend">{legend}</p>'


def columns(parts: Sequence[str]) -> str:
    return '<div class="columns">' + "".join(f"<div>{part}</div>" for part in parts) + "</div>"


def table(head: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """Folded away: the plot is what one sees first."""
    cells = "".join(f"<th>{escape(name)}</th>" for name in head)
    body = "".join("<tr>" + "".join(f"<td>{escape(str(value))}</td>" for value in row) + "</tr>" for row in rows)
    return f'<details><summary>As a table</summary><div class="scroll"><table><tr>{cells}</tr>{body}</table></div></details>'


STYLE = """
:root { color-scheme: light dark; --back: #fff; --text: #17202a; --soft: #5d6b7a; --line: #d5dbe1; --ours: #0b8a3d; --theirs: #9aa6b2; }
@media (prefers-color-scheme: dark) { :root { --back: #12171d; --text: #e6ebf0; --soft: #98a6b5; --line: #2f3944; --ours: #37a562; --theirs: #66727e; } }
body { max-width: 1080px; margin: 24px auto; padding: 0 18px; background: var(--back); color: var(--text); font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 24px; } h2 { font-size: 19px; margin: 36px 0 6px; border-bottom: 1px solid var(--line); } h3 { font-size: 15px; margin: 12px 0 4px; }
nav a { margin-right: 14px; } a { color: inherit; } p { color: var(--soft); margin: 4px 0 10px; }
svg, img { max-width: 100%; height: auto; } img { background: #fff; } svg text { fill: var(--text); font: 12px system-ui, sans-serif; } svg .name { text-anchor: end; }
.ours { fill: var(--ours); } .theirs { fill: var(--theirs); } .range { stroke: var(--text); fill: none; } .bound { fill: none; stroke: var(--soft); }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(460px, 100%), 1fr)); gap: 6px 24px; }
details { margin: 8px 0; } .scroll { overflow-x: auto; } table { border-collapse: collapse; font-size: 13px; }
th, td { border: 1px solid var(--line); padding: 2px 9px; text-align: right; } th { color: var(--soft); } td:first-child, td:nth-child(2) { text-align: left; }
.legend span { margin-right: 16px; white-space: nowrap; } .legend i { display: inline-block; width: 12px; height: 12px; margin-right: 6px; vertical-align: -1px; }
""" + "".join(f".part{i} {{ fill: {colour}; background: {colour}; }}\n" for i, colour in enumerate(
    ["#0b8a3d", "#1b66c9", "#d97706", "#7b4fc9", "#c2334d", "#0e8f9b", "#8a7d1f", "#b0569e", "#7a8794"]))


def document(title: str, sections: Sequence[str]) -> str:
    """The page; its table of contents has what is there."""
    names = {"scan": "scan time", "steps": "steps", "area": "area and clock", "wide": "wide processor", "boards": "boards", "latency": "latency",
             "flow": "flow tasks", "cells": "standard cells", "tradeoff": "the whole trade"}
    links = "".join(f'<a href="#{key}">{name}</a>' for key, name in names.items() if any(f'id="{key}"' in part for part in sections))
    return ('<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>{escape(title)}</title><style>{STYLE}</style></head>\n<body><h1>{escape(title)}</h1>"
            "<p>What was measured, by which command, with which tools. Written by <code>make report</code> from the JSON files beside it.</p>"
            f"<nav>{links}</nav>\n" + "\n".join(sections) + "\n</body></html>\n")
