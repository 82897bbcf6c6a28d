# SPDX-License-Identifier: Apache-2.0
"""What is derived from hdl/isa/controller.toml, modbus.toml and boards.toml: part of gen_isa.py.

rung_controller.vh     Verilog: numbers of spaces, registers and kinds; each configuration's map
rung_controller.h      C, for the firmware: the same, and the holding registers; `AREAS_<config>` lists
                       AREA(table, first, count, index, coils)
rung_controller.hpp    C++: the same as constants and tables in namespace rung::controller
"""
import re
import tomllib
import zlib

GROUPS = {"space": "SPACE", "latch": "LATCH", "refresh": "REFRESH", "setup": "SETUP", "host": "HOST",
          "register": "REG", "holding": "HOLDING"}
TABLES = ("bit", "word")


def load(isa_dir, configs):
    """The tables, checked, with what follows from them."""
    texts = {name: (isa_dir / f"{name}.toml").read_bytes()
             for name in ("controller", "modbus", "boards", "flow")}
    control, modbus, boards, _ = (tomllib.loads(text.decode()) for text in texts.values())
    for group in GROUPS:
        taken = set()
        for row in control[group]:
            places = range(row["number"], row["number"] + row.get("count", row.get("words", 1)))
            assert taken.isdisjoint(places), f"{group} {row['name']}: number is taken"
            taken.update(places)
    maps = {name: areas(modbus, config["modbus"], name) for name, config in configs["config"].items()}
    for name, board in boards["board"].items():
        assert board["config"] in configs["config"], f"board {name}: no such configuration"
        board["inputs"], board["outputs"] = expand(board["inputs"]), expand(board["outputs"])
        assert max(len(board["inputs"]), len(board["outputs"])) <= 64, f"board {name}: too many pins"
    what = texts["controller"] + texts["modbus"] + texts["flow"] + repr(sorted(
        (name, config["modbus"]) for name, config in configs["config"].items())).encode()
    crc = zlib.crc32(what)
    return {"control": control, "maps": maps, "boards": boards["board"],
            "tables": (crc ^ crc >> 16) & 0xFFFF,
            "ids": {name: config["id"] for name, config in configs["config"].items()},
            "devices": {name: {key: config[key] for key in ("bit_devices", "word_devices", "flow")}
                        for name, config in configs["config"].items()}}


def expand(names):
    """["led0..2", "pwm"] -> led0, led1, led2, pwm."""
    out = []
    for name in names:
        match = re.fullmatch(r"(\D+)(\d+)\.\.(\d+)", name)
        out += ([f"{match[1]}{n}" for n in range(int(match[2]), int(match[3]) + 1)] if match
                else [name])
    assert len(set(out)) == len(out), names
    return out


def areas(modbus, counts, config):
    """The areas of one configuration with their place in the device map."""
    out, size, taken = [], dict.fromkeys(TABLES, 0), dict.fromkeys(TABLES, 0)
    assert set(counts) == {area["name"] for area in modbus["area"]}, f"{config}: areas"
    for area in modbus["area"]:
        count = counts[area["name"]]
        assert area["first"] >= taken[area["table"]], f"{config}: {area['name']} overlaps"
        taken[area["table"]] = area["first"] + count
        out.append({"coils": True, "pairs": False, **area, "count": count,
                    "index": size[area["table"]]})
        size[area["table"]] += count
    return {"areas": [area for area in out if area["count"]], **size}


def numbers(tables):
    """(name, number) of every constant, without prefix."""
    out = []
    for group, prefix in GROUPS.items():
        for row in tables["control"][group]:
            out.append((f"{prefix}_{row['name']}", row["number"]))
            count = row.get("count", row.get("words"))
            if count:
                out.append((f"{prefix}_{row['name']}_count", count))
    for group in ("micro", "phases", "flash"):
        out += [(f"{group}_{key}", value) for key, value in tables["control"][group].items()]
    out.append(("tables", tables["tables"]))
    return out


def verilog(tables, notice):
    out = [f"// SPDX-License-Identifier: Apache-2.0\n// {notice}",
           "`ifndef RUNG_CONTROLLER_VH\n`define RUNG_CONTROLLER_VH\n"]
    out += [f"`define RUNG_{name.upper()} {value}" for name, value in numbers(tables)]
    out.append("\n// Parameters of a controller: its configuration's device map")
    for name, sizes in tables["maps"].items():
        out.append(f"`define RUNG_{name.upper()}_MAP .CONFIG_ID({tables['ids'][name]}), "
                   f".BIT_POINTS({sizes['bit']}), .WORD_POINTS({sizes['word']}), "
                   f".FLOW({tables['devices'][name]['flow']})")
    out.append("\n// Parameters of a controller: its board")
    for name, board in tables["boards"].items():
        out.append(f"`define RUNG_BOARD_{name.upper()} .BOARD_ID({board['id']}), "
                   f".INPUTS({len(board['inputs'])}), .OUTPUTS({len(board['outputs'])}), "
                   f".FLASH_BASE({board['flash_base']})")
        for what in ("inputs", "outputs"):
            out.append(f"`define RUNG_BOARD_{name.upper()}_{what.upper()} {len(board[what])}")
    return "\n".join(out + ["\n`endif\n"])


def c_header(tables, notice, more):
    """`more`: further constants, as numbers() gives them."""
    out = [f"/* SPDX-License-Identifier: Apache-2.0 */\n/* {notice} */",
           "#ifndef RUNG_CONTROLLER_H\n#define RUNG_CONTROLLER_H\n"]
    out += [f"#define {name.upper()} {value}" for name, value in numbers(tables) + more]
    for name, sizes in tables["maps"].items():
        rows = " ".join(f"AREA({TABLES.index(a['table'])}, {a['first']}, {a['count']}, {a['index']}, "
                        f"{int(a['coils'])})" for a in sizes["areas"])
        out.append(f"#define AREAS_{name} {rows}")
        for table in TABLES:
            out.append(f"#define {table.upper()}_POINTS_{name} {sizes[table]}")
        for key, count in tables["devices"][name].items():
            out.append(f"#define {key.upper()}_{name} {count}")
    return "\n".join(out + ["\n#endif\n"])


def cpp(tables, notice):
    def quoted(names):
        return "{" + ", ".join(f'"{name}"' for name in names) + "}"

    out = [f"// SPDX-License-Identifier: Apache-2.0\n// {notice}", "#pragma once\n",
           "#include <string_view>\n#include <vector>\n", '#include "rungs/device.hpp"\n',
           "namespace rung::controller {\n"]
    out += [f"inline constexpr int {name.lower()} = {value};" for name, value in numbers(tables)]
    out.append("""
// A run of Modbus addresses (hdl/isa/modbus.toml): device `number` + n is at `first` + n, or with pairs at
// `first` + 2n, and point `index` + n of its table's device map.
struct Area {
  std::string_view config, name;
  DeviceKind kind;
  int number, first, count, index;
  bool coils, pairs;
};
inline constexpr Area areas[] = {""")
    for name, sizes in tables["maps"].items():
        for a in sizes["areas"]:
            out.append(f'    {{"{name}", "{a["name"]}", DeviceKind::{a["kind"]}, {a["number"]}, {a["first"]}, '
                       f'{a["count"]}, {a["index"]}, {str(a["coils"]).lower()}, {str(a["pairs"]).lower()}}},')
    out.append("""};

// A board (hdl/isa/boards.toml): names of pins in the order of their numbers.
struct Board {
  std::string_view name, title, config;
  int id, mpu, flash_base, adc;
  std::vector<std::string_view> inputs, outputs, pwm, uart;
};
inline const std::vector<Board>& boards() {
  static const std::vector<Board> all = {""")
    for name, b in tables["boards"].items():
        out.append(f'      {{"{name}", "{b["title"]}", "{b["config"]}", {b["id"]}, {b["mpu"]}, '
                   f'{b["flash_base"]}, {b["adc"]}, {quoted(b["inputs"])}, {quoted(b["outputs"])}, '
                   f'{quoted(b["pwm"])}, {quoted(b["uart"])}}},')
    out.append("  };\n  return all;\n}\n")
    out.append("struct ConfigId {\n  std::string_view config;\n  int id, bit_points, word_points;\n};")
    out.append("inline constexpr ConfigId config_ids[] = {")
    for name, sizes in tables["maps"].items():
        out.append(f'    {{"{name}", {tables["ids"][name]}, {sizes["bit"]}, {sizes["word"]}}},')
    return "\n".join(out + ["};\n", "}  // namespace rung::controller\n"])
