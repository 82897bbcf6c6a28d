/* SPDX-License-Identifier: Apache-2.0
 * What engine_main.c calls: a ladder program as C or as byte code. */
#ifndef RUNG_ENGINE_H
#define RUNG_ENGINE_H

#include <stdint.h>

/* Makes the program ready; `file` is the command's first argument, if there is one. 0: it is. */
int engine_start(const char* file);

/* One scan; input number i of the program has bit i % 32 of `inputs`. */
void engine_scan(uint32_t inputs);

#endif
