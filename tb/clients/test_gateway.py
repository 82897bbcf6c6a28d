# SPDX-License-Identifier: Apache-2.0
"""pymodbus on the gateway's port (Modbus TCP on loopback), alone and beside a client on the terminal."""
from __future__ import annotations

import contextlib
import socket
import threading
import unittest

from pymodbus import FramerType
from pymodbus.client import ModbusSerialClient, ModbusTcpClient

from bench import cell

NO_RESPONSE, NO_PATH = 0x0B, 0x0A


class Gateway(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.device = cls.enterClassContext(cell("--tcp", "0"))

    def client(self) -> ModbusTcpClient:
        client = ModbusTcpClient("127.0.0.1", port=self.device.tcp_port, timeout=20, retries=0)
        self.assertTrue(client.connect())
        self.addCleanup(client.close)
        return client

    def test_read_write_and_exception(self) -> None:
        client = self.client()
        self.assertFalse(client.write_registers(0, [7, 8]).isError())
        self.assertEqual(client.read_holding_registers(0, count=2).registers, [7, 8])
        self.assertEqual(client.read_holding_registers(0x4000).exception_code, 2)
        self.assertIn(b"Rung", b"".join(client.read_device_information(read_code=1).information.values()))

    def test_unit_that_is_not_there(self) -> None:
        client = self.client()
        self.assertEqual(client.read_holding_registers(0, device_id=9).exception_code, NO_RESPONSE)
        self.assertEqual(client.read_holding_registers(0, device_id=250).exception_code, NO_PATH)

    def test_clients_side_by_side(self) -> None:
        """Two on the gateway and one on the terminal; each sees its own answers only."""
        wrong: list[str] = []

        def work(client, address: int) -> None:
            for value in range(30):
                client.write_register(address, value)
                got = client.read_holding_registers(address)
                if got.isError() or got.registers != [value]:
                    wrong.append(f"{address}: wrote {value}, read {got}")

        terminal = ModbusSerialClient(self.device.link, framer=FramerType.RTU, baudrate=19200,
                                      timeout=20, retries=0)
        self.assertTrue(terminal.connect())
        with contextlib.closing(terminal):
            threads = [threading.Thread(target=work, args=(client, address)) for address, client in
                       ((0, self.client()), (1, self.client()), (20, terminal))]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join(60)
                self.assertFalse(thread.is_alive())
        self.assertEqual(wrong, [])

    def test_bad_header_closes(self) -> None:
        with socket.create_connection(("127.0.0.1", self.device.tcp_port), timeout=20) as bad:
            bad.sendall(bytes.fromhex("0001 0000 ffff 01 03 0000 0001"))
            self.assertEqual(bad.recv(100), b"")
        self.assertFalse(self.client().read_holding_registers(0).isError())


if __name__ == "__main__":
    unittest.main()
