/* Says what the codec makes of each line of its input, for a comparison with the Rust crate's.
 *
 *   f HEX        a frame: what every decoder says, and the bytes that it writes again
 *   s HEX        a stream of bytes: what the deframer finds
 *   p HEX ...    pieces of classic CAN: what the assembler finds
 *   n NUMBER     a slope: its code, and the value of the code
 */
#include "../letoff_codec.h"

#include <stdio.h>
#include <stdlib.h>

#define MOST 4096

static void print_hex(char mark, const uint8_t *bytes, size_t len)
{
    putchar(' ');
    putchar(mark);
    for (size_t i = 0; i < len; i++) {
        printf("%02x", bytes[i]);
    }
}

static const char *hex(const char *at, uint8_t *bytes, size_t *len)
{
    *len = 0;
    while (*at != 0 && *at != ' ' && *len < MOST) {
        char digits[] = {at[0], at[1], 0};
        bytes[(*len)++] = (uint8_t)strtoul(digits, NULL, 16);
        at += 2;
    }
    return at + (*at == ' ');
}

static void answer(enum letoff_refusal refusal, const uint8_t *again, size_t len)
{
    if (refusal == LETOFF_TAKEN) {
        print_hex('=', again, len);
    } else {
        printf(" %d", (int)refusal);
    }
}

static void cyclic(const uint8_t *frame, size_t len, uint8_t n_keys)
{
    uint8_t again[LETOFF_MAX_FRAME];
    for (uint8_t packing = 0; packing < 4; packing++) {
        struct letoff_samples samples;
        enum letoff_refusal refusal = letoff_samples_take(&samples, packing, n_keys, frame, len);
        answer(refusal, again, refusal == LETOFF_TAKEN ? letoff_samples_put(&samples, again) : 0);
    }
    for (uint8_t packing = 0; packing < 3; packing++) {
        struct letoff_forces forces;
        enum letoff_refusal refusal = letoff_forces_take(&forces, packing, n_keys, frame, len);
        answer(refusal, again, refusal == LETOFF_TAKEN ? letoff_forces_put(&forces, again) : 0);
    }
}

static void acyclic(const uint8_t *frame, size_t len)
{
    struct letoff_acyclic said;
    uint8_t again[LETOFF_MAX_FRAME];
    enum letoff_refusal refusal = letoff_request_take(&said, frame, len);
    if (refusal == LETOFF_TAKEN) {
        letoff_request_head(again, said.board, said.id, said.operation);
        memcpy(again + LETOFF_REQUEST_HEAD, said.record, said.record_len);
    }
    answer(refusal, again, len);
    refusal = letoff_reply_take(&said, frame, len);
    if (refusal == LETOFF_TAKEN) {
        letoff_reply_head(again, said.board, said.id, said.operation, said.status);
        memcpy(again + LETOFF_REPLY_HEAD, said.record, said.record_len);
    }
    answer(refusal, again, len);
}

static void frame_line(const uint8_t *frame, size_t len)
{
    uint8_t again[LETOFF_MAX_FRAME];
    struct letoff_multicast multicast;
    struct letoff_broadcast broadcast;
    struct letoff_introduction hello;
    printf("%d", (int)letoff_can_id(frame, len));
    cyclic(frame, len, 1);
    cyclic(frame, len, 11);
    cyclic(frame, len, 12);
    enum letoff_refusal refusal = letoff_multicast_take(&multicast, frame, len);
    answer(refusal, again, refusal == LETOFF_TAKEN ? letoff_multicast_put(&multicast, again) : 0);
    refusal = letoff_broadcast_take(&broadcast, frame, len);
    answer(refusal, again, refusal == LETOFF_TAKEN ? letoff_broadcast_put(&broadcast, again) : 0);
    refusal = letoff_introduction_take(&hello, frame, len);
    answer(refusal, again, refusal == LETOFF_TAKEN ? letoff_introduction_put(&hello, again) : 0);
    acyclic(frame, len);
}

static void stream_line(const uint8_t *bytes, size_t len)
{
    struct letoff_deframer deframer = {0};
    for (size_t i = 0; i < len; i++) {
        enum letoff_framing found = letoff_deframe(&deframer, bytes[i]);
        if (found == LETOFF_FRAME) {
            uint8_t wire[LETOFF_MAX_WIRE];
            print_hex('=', deframer.buffer, deframer.len);
            print_hex('~', wire, letoff_wire(deframer.buffer, deframer.len, wire));
        } else if (found != LETOFF_NOTHING_YET) {
            printf(" %d", (int)found);
        }
    }
}

static void pieces_line(const char *at)
{
    struct letoff_assembler all = {0};
    static uint8_t piece[MOST];
    while (*at != 0) {
        size_t len;
        at = hex(at, piece, &len);
        enum letoff_assembly found = letoff_assemble(&all, piece, len);
        if (found == LETOFF_WHOLE) {
            print_hex('=', all.buffer, all.len);
        } else {
            printf(" %d", (int)found);
        }
    }
}

int main(void)
{
    static char line[2 * MOST + 16];
    while (fgets(line, sizeof line, stdin) != NULL) {
        line[strcspn(line, "\n")] = 0;
        size_t len = 0;
        if (line[0] == 'p') {
            pieces_line(line + 2);
        } else if (line[0] == 'n') {
            uint8_t code = letoff_slope_code((int32_t)strtol(line + 2, NULL, 10));
            printf("%d %d", (int)code, (int)letoff_slope(code));
        } else {
            static uint8_t bytes[MOST];
            hex(line + 2, bytes, &len);
            /* A copy of its own, so that a byte read behind it is found out. */
            uint8_t *copy = malloc(len == 0 ? 1 : len);
            if (copy == NULL) {
                return EXIT_FAILURE;
            }
            memcpy(copy, bytes, len);
            if (line[0] == 'f') {
                frame_line(copy, len);
            } else {
                stream_line(copy, len);
            }
            free(copy);
        }
        putchar('\n');
    }
    return EXIT_SUCCESS;
}
