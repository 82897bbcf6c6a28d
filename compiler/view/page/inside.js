// SPDX-License-Identifier: Apache-2.0
export function setUp() {}
export function load() {}
export function shown() {}
