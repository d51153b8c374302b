#!/usr/bin/env python3
"""Writes transfer_v1.prt: a transfer file laid out by hand from the description in examples/common/transfer_file.h,
by no code of this project. Run in tests/golden: python3 gen_transfer.py"""
import struct


def fnv(data):
    h = 14695981039346656037
    for b in data:
        h = (h ^ b) * 1099511628211 % 2**64
    return h


rows = lambda first, count: b"".join(struct.pack("<f", 0.25 * (first * 4 + i) - 3) for i in range(4 * count))
head = b"\x89PRT\r\n\x1a\n" + struct.pack("<IIIfQQQQ", 1, 2, 1024, 0.5, 0x0123456789ABCDEF, 9, 0xFEDCBA9876543210, 2)
body = head + struct.pack("<Q", fnv(head))
for first, count in ((1, 3), (6, 2)):
    body += struct.pack("<QQ", first, count) + rows(first, count)
with open("transfer_v1.prt", "wb") as f:
    f.write(body + struct.pack("<Q", fnv(body)))
