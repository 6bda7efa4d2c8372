"""A rank of a job of workers that is of another version: run by mpirun beside gluray-worker. Does what it does when it starts."""
import struct
import sys
import time

from mpi4py import MPI

HELLO, ORDER = 0x4848, 0x01020304  # RankHello

messages = MPI.COMM_WORLD.Dup()
broadcasts = MPI.COMM_WORLD.Dup()
here = messages.Split_type(MPI.COMM_TYPE_SHARED, messages.rank)
here.Free()


def text(value):
    return struct.pack("=Q", len(value)) + value.encode()


messages.Send(struct.pack("=HI", HELLO, ORDER) + text(sys.argv[1]) + text("node7"), dest=0, tag=1)
time.sleep(60)
