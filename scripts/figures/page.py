"""Tables and pages made of the rows of figures.json.

Placeholders of page.md:
  {{table Figure 10}}            the figure's rows as a table
  {{rows Jacksboro}}             the same with the uniform grid and cited figures beside
  {{saving}}                     triangles without and with ct
  {{value KEY FIELD}}            one number, such as {{value figure-11-a triangles}}
"""
import re


def number(value):
    """1,234 for counts; three significant digits otherwise."""
    if isinstance(value, int):
        return f"{value:,}"
    if value >= 10:
        return f"{value:.1f}"
    return f"{value:.2f}" if value >= 1 else f"{value:.2g}" if value < 0.001 else f"{value:.4f}"


def markdown(head, lines):
    alignment = ["---"] + ["---:"] * (len(head) - 1)
    return "\n".join("| " + " | ".join(line) + " |" for line in [head, alignment, *lines])


def saved(row):
    tests, skips = row["edge_tests"], row["settled_skips"]
    return f"{100 * skips / (tests + skips):.0f} %" if tests + skips else "0 %"


def table(rows):
    unit = next((r["unit"] for r in rows if "unit" in r), "world units")
    head = ["", "triangles", f"RMS, {unit}", f"maximum, {unit}", "edge tests", "saved by settled edges"]
    return markdown(head, [[r["variant"], number(r["triangles"]), number(r["rms"]) if "rms" in r else "",
                            number(r["max"]) if "max" in r else "", number(r["edge_tests"]), saved(r)] for r in rows])


def pair(record, rms="rms", largest="max"):
    return f"{number(float(record[rms]))} / {record[largest]:.0f}" if record else ""


def comparison(rows):
    head = ["RMS / maximum, m", "triangles", "relievo", "greedy insertion (external)", "uniform grid",
            "RMS ÷ greedy", "RMS ÷ uniform"]
    lines = []
    for r in rows:
        cited, uniform = r.get("cited"), r["uniform"]
        lines.append([r["variant"], number(r["triangles"]), pair(r), pair(cited, "greedy_rms", "greedy_max"), pair(uniform),
                      f"{r['rms'] / cited['greedy_rms']:.2f}" if cited else "", f"{r['rms'] / uniform['rms']:.2f}"])
    return markdown(head, lines)


def saving(rows):
    lines = []
    for off, on in zip(rows[::2], rows[1::2]):
        share = f"{100 * (1 - on['triangles'] / off['triangles']):.0f} %"
        lines.append([off["variant"].replace(", without ct", ""), number(off["triangles"]), number(on["triangles"]), share,
                      f"{number(off['rms'])} → {number(on['rms'])} {on['unit']}"])
    return markdown(["", "without ct", "with ct", "saved", "RMS without → with ct"], lines)


def page(template, rows):
    def of(figure):
        return [r for r in rows if r["figure"] == figure]

    by_key = {r["key"]: r for r in rows}

    def filled(match):
        kind, _, rest = match[1].partition(" ")
        if kind == "table":
            return table(of(rest))
        if kind == "rows":
            return comparison(of(rest))
        if kind == "saving":
            return saving(of("Tex coord test"))
        key, field = rest.split()
        return number(by_key[key][field])

    return re.sub(r"\{\{(.*?)\}\}", filled, template)


def gallery(rows):
    """Every figure of the rows: pictures, then the table."""
    out = ["# Figures of data that the repository does not hold", "", "Made by `scripts/figures.sh` from `../shared/data`."]
    for figure in dict.fromkeys(r["figure"] for r in rows):
        group = [r for r in rows if r["figure"] == figure]
        pictures = " ".join(f"![{r['variant']}]({p})" for r in group for p in r["pictures"])
        out += ["", f"## {figure}", *(["", pictures] if pictures else []), "",
                saving(group) if figure == "Tex coord test" else table(group)]
        out += [f"\n{r['variant']}: {r['water_triangles']:,} triangles on {r['water_base_triangles']:,} base triangles of open water."
                for r in group if "water_triangles" in r]
    return "\n".join(out) + "\n"


def plain(rows):
    """For the terminal."""
    lines = [f"{'':60} {'triangles':>10} {'RMS':>10} {'maximum':>10}  {'':11} {'edge tests':>11} {'settled':>8}"]
    for r in rows:
        lines.append(f"{r['figure'] + ': ' + r['variant']:60.60} {r['triangles']:>10,} {number(r['rms']) if 'rms' in r else '':>10} "
                     f"{number(r['max']) if 'max' in r else '':>10}  {r.get('unit', ''):11} {r['edge_tests']:>11,} {saved(r):>8}")
    return "\n".join(lines)
