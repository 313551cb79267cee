#include "wire.h"

#include "../firmware/uart.h"
#include "../letoff_codec.h"
#include "faults.h"
#include "random.h"

#include <stdio.h>
#include <string.h>

/* Packets under way, each way: two seconds of samples at 2 kHz. */
#define PACKETS 4096u

struct queue {
    struct packet packets[PACKETS];
    /* Both run on and wrap. */
    uint32_t head;
    uint32_t tail;
};

static struct queue to_board;
static struct queue to_host;
static struct random chance;
static uint64_t latency_us;
static uint64_t now_us;
static bool blocked;
/* Bytes from the host up to the next zero. */
static struct packet partial;
/* Frames to the host. */
static uint64_t frames;

void wire_begin(uint64_t seed, uint64_t latency)
{
    chance = random_from(seed, 4);
    latency_us = latency;
}

void wire_at(uint64_t now)
{
    now_us = now;
}

void wire_block(bool is_blocked)
{
    blocked = is_blocked;
}

/* ---- Under way. ---- */

static uint64_t due(void)
{
    uint64_t due_us = now_us + latency_us;
    if (fault_is_on(FAULT_LATENCY)) {
        due_us += (uint64_t)fault_value(FAULT_LATENCY);
    }
    if (fault_is_on(FAULT_JITTER)) {
        due_us += (uint64_t)random_between(&chance, 0.0, fault_value(FAULT_JITTER));
    }
    return due_us;
}

static void invert_bits(struct packet *packet)
{
    for (size_t bit = 0; bit < 8 * packet->len; bit++) {
        if (random_chance(&chance, fault_value(FAULT_CORRUPT))) {
            packet->bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
        }
    }
}

/* Adds bytes, at most PACKET_ROOM; returns `false` if there is no room. */
static bool push(struct queue *queue, const uint8_t *bytes, size_t len, uint64_t due_us)
{
    if (queue->head - queue->tail == PACKETS) {
        return false;
    }
    struct packet *packet = &queue->packets[queue->head % PACKETS];
    packet->due_us = due_us;
    /* Bytes do not overtake each other. */
    if (queue->head != queue->tail) {
        uint64_t before_us = queue->packets[(queue->head - 1u) % PACKETS].due_us;
        packet->due_us = due_us < before_us ? before_us : due_us;
    }
    packet->len = len;
    memcpy(packet->bytes, bytes, len);
    if (fault_is_on(FAULT_CORRUPT)) {
        invert_bits(packet);
    }
    queue->head++;
    return true;
}

static const struct packet *pop(struct queue *queue, size_t room)
{
    const struct packet *packet = &queue->packets[queue->tail % PACKETS];
    if (queue->head == queue->tail || now_us < packet->due_us || room < packet->len) {
        return NULL;
    }
    queue->tail++;
    return packet;
}

/* ---- To the host. ---- */

static bool push_to_host(const uint8_t *bytes, size_t len)
{
    uint64_t due_us = due();
    if (fault_is_on(FAULT_BURST)) {
        uint64_t interval_us = (uint64_t)(1e3 * fault_value(FAULT_BURST));
        due_us += interval_us - 1u;
        due_us -= due_us % interval_us;
    }
    return push(&to_host, bytes, len, due_us);
}

static void push_text(const char *text)
{
    size_t len = strlen(text);
    for (size_t at = 0; at < len; at += PACKET_ROOM) {
        size_t rest = len - at;
        (void)push_to_host((const uint8_t *)text + at, rest < PACKET_ROOM ? rest : PACKET_ROOM);
    }
}

void wire_boot(void)
{
    if (fault_is_on(FAULT_BOOTTEXT)) {
        push_text("ets Jul 29 2019 12:21:46\r\n\r\n"
                  "rst:0x1 (POWERON_RESET),boot:0x13 (SPI_FAST_FLASH_BOOT)\r\n"
                  "configsip: 0, SPIWP:0xee\r\nmode:DIO, clock div:1\r\n"
                  "load:0x3fff0030,len:1184\r\nentry 0x400805e4\r\n"
                  "I (57) boot: letoff board, compiled today\r\n");
    }
}

/* Makes a hello, at `record`, that of an older board. */
static void make_older(uint8_t *record, uint8_t minor)
{
    uint8_t *at = record + LETOFF_HELLO_FEATURES_AT;
    record[LETOFF_HELLO_MINOR_AT] = minor;
    if (minor < 2u) {
        uint64_t since_2_2 = LETOFF_FEATURE_HEALTH | LETOFF_FEATURE_BOOTLOADER;
        letoff_put(at, letoff_take(at, 2) & ~since_2_2, 2);
    }
}

/* Writes the bytes with which an older board would answer; returns their length. */
static size_t older(const uint8_t *bytes, size_t len, uint8_t wire[LETOFF_MAX_WIRE])
{
    struct letoff_deframer deframer = {0};
    for (size_t i = 0; i < len; i++) {
        letoff_deframe(&deframer, bytes[i]);
    }
    uint8_t *frame = deframer.buffer;
    size_t n = deframer.len;
    uint8_t minor = (uint8_t)fault_value(FAULT_OLDMINOR);
    if (letoff_kind(frame) == LETOFF_KIND_HELLO) {
        make_older(frame + 1, minor);
    } else if (letoff_kind(frame) == LETOFF_KIND_REPLY) {
        if (frame[2] == LETOFF_OPERATION_HELLO) {
            make_older(frame + LETOFF_REPLY_HEAD, minor);
        } else if (minor < 2u && LETOFF_OPERATION_BOARD_HEALTH <= frame[2]) {
            frame[3] = LETOFF_STATUS_UNKNOWN;
            n = LETOFF_REPLY_HEAD;
        }
    }
    return letoff_wire(frame, n, wire);
}

/* The firmware sends one whole frame at a time. */
bool uart_write(const uint8_t *bytes, size_t len)
{
    uint8_t wire[LETOFF_MAX_WIRE];
    if (blocked) {
        return false;
    }
    if (fault_is_on(FAULT_OLDMINOR)) {
        len = older(bytes, len, wire);
        bytes = wire;
    }
    frames++;
    if (fault_is_on(FAULT_TEXT) && frames % (uint64_t)fault_value(FAULT_TEXT) == 0) {
        char text[64];
        snprintf(text, sizeof text, "frame %llu sent, all well\r\n", (unsigned long long)frames);
        push_text(text);
    }
    if (fault_is_on(FAULT_DROP) && random_chance(&chance, fault_value(FAULT_DROP))) {
        return true;
    }
    bool sent = push_to_host(bytes, len);
    return fault_is_on(FAULT_REPEAT) ? push_to_host(bytes, len) : sent;
}

const struct packet *wire_to_host(size_t room)
{
    return pop(&to_host, room);
}

uint64_t wire_idle(uint64_t most_us)
{
    if (to_host.head == to_host.tail || blocked) {
        return most_us;
    }
    uint64_t due_us = to_host.packets[to_host.tail % PACKETS].due_us;
    uint64_t idle_us = due_us < now_us ? 0 : due_us - now_us;
    return idle_us < most_us ? idle_us : most_us;
}

/* ---- To the board. ---- */

/* Returns `true` if the packet is a frame of forces. */
static bool has_forces(struct letoff_deframer *deframer, const struct packet *packet)
{
    enum letoff_framing found = LETOFF_NOTHING_YET;
    for (size_t i = 0; i < packet->len; i++) {
        found = letoff_deframe(deframer, packet->bytes[i]);
    }
    if (found != LETOFF_FRAME || deframer->len == 0) {
        return false;
    }
    uint8_t kind = letoff_kind(deframer->buffer);
    return kind == LETOFF_KIND_KEY_FORCES || kind == LETOFF_KIND_MULTICAST_FORCES;
}

static void shorten_forces(struct packet *packet)
{
    struct letoff_deframer deframer = {0};
    uint8_t wire[LETOFF_MAX_WIRE];
    if (has_forces(&deframer, packet)) {
        packet->len = letoff_wire(deframer.buffer, deframer.len - 1u, wire);
        memcpy(packet->bytes, wire, packet->len);
    }
}

static void finish_packet(void)
{
    bool lost = fault_is_on(FAULT_DROPDOWN) && random_chance(&chance, fault_value(FAULT_DROPDOWN));
    if (fault_is_on(FAULT_WRONGLEN)) {
        shorten_forces(&partial);
    }
    if (!lost) {
        (void)push(&to_board, partial.bytes, partial.len, due());
    }
    partial.len = 0;
}

void wire_receive(const uint8_t *bytes, size_t len)
{
    for (size_t i = 0; i < len; i++) {
        partial.bytes[partial.len++] = bytes[i];
        if (bytes[i] == 0 || partial.len == PACKET_ROOM) {
            if (fault_is_on(FAULT_ECHO)) {
                (void)push_to_host(partial.bytes, partial.len);
            }
            finish_packet();
        }
    }
}

const struct packet *wire_to_board(void)
{
    return pop(&to_board, PACKET_ROOM);
}
