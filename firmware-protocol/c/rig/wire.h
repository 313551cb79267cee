/* Link between board and host, and its faults. */
#ifndef WIRE_H
#define WIRE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Bytes that travel together. */
#define PACKET_ROOM 256

struct packet {
    uint64_t due_us;
    size_t len;
    uint8_t bytes[PACKET_ROOM];
};

/* `latency_us` is that of each way. */
void wire_begin(uint64_t seed, uint64_t latency_us);

/* Sets the time of all later calls. */
void wire_at(uint64_t now_us);

/* While the host does not read, the board cannot send. */
void wire_block(bool blocked);

/* Takes bytes that the host sent. */
void wire_receive(const uint8_t *bytes, size_t len);

/* Next bytes that have arrived at the board, else NULL; valid until the next call. */
const struct packet *wire_to_board(void);

/* Next bytes that have arrived at the host and have at most `room`, else NULL. */
const struct packet *wire_to_host(size_t room);

/* Time until the next bytes for the host are due [us], at most `most_us`. */
uint64_t wire_idle(uint64_t most_us);

/* Puts the boot log on the wire, if that fault is on. */
void wire_boot(void);

#endif
