# SPDX-License-Identifier: Apache-2.0
"""pymodbus on the pseudo-terminal: every area, every function code, every exception."""
from __future__ import annotations

import unittest

from pymodbus import FramerType
from pymodbus.client import ModbusSerialClient
from pymodbus.exceptions import ModbusIOException

from bench import areas, cell, eventually, holding

ILLEGAL_FUNCTION, ILLEGAL_ADDRESS, ILLEGAL_VALUE = 1, 2, 3


def serial(port: str, seconds: float = 10) -> ModbusSerialClient:
    client = ModbusSerialClient(port, framer=FramerType.RTU, baudrate=19200, timeout=seconds,
                                retries=0)
    if not client.connect():
        raise AssertionError(f"pymodbus cannot open {port}")
    return client


class Pymodbus(unittest.TestCase):
    """One device for all of them; each leaves the program as it found it."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.device = cls.enterClassContext(cell())
        cls.client = serial(cls.device.link)
        cls.addClassCleanup(cls.client.close)

    def right(self, reply):
        self.assertFalse(reply.isError(), reply)
        return reply

    def bits(self, address: int, count: int = 1, discrete: bool = False) -> list[bool]:
        read = self.client.read_discrete_inputs if discrete else self.client.read_coils
        return self.right(read(address, count=count)).bits[:count]

    def words(self, address: int, count: int = 1) -> list[int]:
        return self.right(self.client.read_holding_registers(address, count=count)).registers

    def refused(self, code: int, reply) -> None:
        self.assertTrue(reply.isError(), reply)
        self.assertEqual(reply.exception_code, code, reply)

    def test_every_area_first_and_last(self) -> None:
        for area in areas():
            for address in (area.first, area.end - 1):
                with self.subTest(area=area.name, address=hex(address)):
                    if area.table == "word":
                        self.assertEqual(len(self.words(address)), 1)
                        self.assertEqual(
                            self.right(self.client.read_input_registers(address)).registers,
                            self.words(address))
                    else:
                        self.assertEqual(len(self.bits(address, discrete=True)), 1)
                        if area.coils:
                            self.assertEqual(len(self.bits(address)), 1)

    def test_behind_every_area_is_exception_2(self) -> None:
        starts = {(area.table, area.first) for area in areas()}
        for area in areas():
            if (area.table, area.end) in starts:
                continue
            with self.subTest(area=area.name, address=hex(area.end)):
                if area.table == "word":
                    self.refused(ILLEGAL_ADDRESS, self.client.read_holding_registers(area.end))
                    self.refused(ILLEGAL_ADDRESS, self.client.read_input_registers(area.end - 1, count=2))
                    self.refused(ILLEGAL_ADDRESS, self.client.write_register(area.end, 1))
                else:
                    self.refused(ILLEGAL_ADDRESS, self.client.read_discrete_inputs(area.end))
                    self.refused(ILLEGAL_ADDRESS, self.client.write_coil(area.end, True))

    def test_devices_that_the_program_does_not_name(self) -> None:
        for area in areas():
            address = area.end - 1
            with self.subTest(area=area.name):
                if area.table == "word":
                    self.right(self.client.write_register(address, 4711))
                    self.assertEqual(self.words(address), [0])
                elif area.coils:
                    self.right(self.client.write_coil(address, True))
                    self.assertEqual(self.bits(address), [False])

    def test_inputs_cannot_be_written(self) -> None:
        inputs = next(area for area in areas() if area.name == "X")
        self.refused(ILLEGAL_ADDRESS, self.client.write_coil(inputs.first, True))
        self.refused(ILLEGAL_ADDRESS, self.client.write_coils(inputs.first, [True] * 4))

    def test_words_1_and_many(self) -> None:
        """FC 3, 4, 6, 16; the program adds D0 and D1 to D2."""
        self.right(self.client.write_register(0, 1200))
        self.right(self.client.write_registers(1, [34]))
        eventually(self, lambda: self.words(2) == [1234])
        self.right(self.client.write_registers(0, [0xFFFF, 1]))
        eventually(self, lambda: self.words(0, 3) == [0xFFFF, 1, 0])
        self.assertEqual(self.right(self.client.read_input_registers(0, count=2)).registers, [0xFFFF, 1])
        self.assertEqual(len(self.words(0, 125)), 125)
        self.right(self.client.write_registers(0x100, list(range(123))))

    def test_bits_1_and_many(self) -> None:
        """FC 1, 2, 5, 15; M0 is Y1."""
        self.right(self.client.write_coil(0, True))
        eventually(self, lambda: self.bits(0x3301) == [True])
        self.right(self.client.write_coils(0, [False, True]))
        eventually(self, lambda: self.bits(0x3301) == [False])
        self.assertEqual(self.bits(0, 2), [False, True])
        self.right(self.client.write_coils(0, [False, False]))
        self.assertEqual(len(self.bits(0, 128)), 128)
        # S5 is M5, by the program.
        self.right(self.client.write_coil(0x2005, True))
        eventually(self, lambda: self.bits(5) == [True])
        self.right(self.client.write_coil(0x2005, False))

    def test_more_points_than_the_exchange_has(self) -> None:
        points = self.words(holding("exchange_points"))[0]
        self.assertEqual(points, 128)
        self.assertEqual(len(self.bits(0, points)), points)
        self.assertTrue(self.client.read_coils(0, count=points + 1).isError())

    def test_mask_write(self) -> None:
        """FC 22, with the numbers of the specification."""
        self.right(self.client.write_register(0, 0x0012))
        self.right(self.client.mask_write_register(address=0, and_mask=0x00F2, or_mask=0x0025))
        self.assertEqual(self.words(0), [0x0017])
        self.refused(ILLEGAL_ADDRESS,
                     self.client.mask_write_register(address=0x4000, and_mask=0, or_mask=0))

    def test_read_and_write_at_once(self) -> None:
        """FC 23 writes before it reads."""
        reply = self.client.readwrite_registers(read_address=0, read_count=2, write_address=1,
                                                values=[77])
        self.assertEqual(self.right(reply).registers[1], 77)
        self.refused(ILLEGAL_ADDRESS,
                     self.client.readwrite_registers(read_address=0x4000, read_count=2,
                                                     write_address=1, values=[78]))
        self.assertEqual(self.words(1), [77], "a refused request has written nothing")

    def test_loop_back(self) -> None:
        """FC 8, sub-function 0."""
        reply = self.right(self.client.diag_query_data(b"\xA5\x37"))
        self.assertIn(reply.message, (b"\xA5\x37", [0xA537], 0xA537))

    def test_device_identification(self) -> None:
        """FC 43/14, basic."""
        reply = self.right(self.client.read_device_information(read_code=1, object_id=0))
        self.assertEqual(sorted(reply.information), [0, 1, 2])
        self.assertIn(b"Rung", reply.information[0] + reply.information[1])

    def test_functions_and_values_that_are_not(self) -> None:
        self.refused(ILLEGAL_FUNCTION, self.client.read_exception_status())
        self.refused(ILLEGAL_FUNCTION, self.client.report_device_id())
        # The client would not send these on its own.
        for function, body in ((1, b"\0\0\0\0"), (3, b"\0\0\0\x7e"), (5, b"\0\0\x12\x34"),
                               (15, b"\0\0\0\x08\x02\0\0"), (16, b"\0\0\0\x02\x02\0\0")):
            with self.subTest(function=function, body=body.hex()):
                self.refused(ILLEGAL_VALUE, self.raw(function, body))

    def raw(self, function: int, body: bytes):
        from pymodbus.pdu.register_message import ReadHoldingRegistersRequest

        class Raw(ReadHoldingRegistersRequest):
            function_code = function

            def encode(self) -> bytes:
                return body

        request = Raw(address=0, count=1, dev_id=1)
        return self.client.execute(False, request)

    def test_all_of_a_request_is_of_one_scan(self) -> None:
        for _ in range(100):
            self.assertEqual(len(set(self.words(10, 5))), 1)

    def test_another_unit_does_not_answer(self) -> None:
        self.client.close()
        impatient = serial(self.device.link, seconds=1)
        with self.assertRaises(ModbusIOException):
            impatient.read_holding_registers(0, device_id=9)
        impatient.close()
        self.assertTrue(self.client.connect())
        self.assertEqual(len(self.words(0)), 1)

    def test_scan_takes_the_same_clocks_under_a_client_at_full_speed(self) -> None:
        self.right(self.client.write_register(holding("command"), 4))
        frames = self.words(holding("frames"))[0]
        for value in range(150):
            self.right(self.client.write_register(0, value))
            self.words(0, 20)
            self.bits(0, 100)
        self.assertGreaterEqual((self.words(holding("frames"))[0] - frames) % 65536, 450)
        low = self.words(holding("scan_min"), 2)
        high = self.words(holding("scan_max"), 2)
        self.assertEqual(low, high)
        self.assertGreater(low[0], 0)

    def test_pins(self) -> None:
        """Start, seal in and stop by pins, seen by the client and at the output."""
        since = self.device.tell("in0=1")
        self.device.wait_for(r"out0=1", since)
        self.assertEqual(self.bits(0x3400, 1, discrete=True), [True])
        self.device.tell("in0=0")
        eventually(self, lambda: self.bits(0x3400, 1, discrete=True) == [False])
        self.assertEqual(self.bits(0x3300), [True])
        since = self.device.tell("in1=1")
        self.device.wait_for(r"out0=0", since)
        self.device.tell("in1=0")


if __name__ == "__main__":
    unittest.main()
