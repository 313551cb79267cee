/* Frames of the Letoff protocol as C99 structs: what firmware needs, and what tests need.
 *
 * No heap, no floating point, nothing that C leaves undefined or to the compiler. Take
 * letoff_protocol.h, letoff_codec.h and letoff_codec.c; there is nothing else.
 *
 * Signs: down is positive for positions and velocities, up is positive for forces.
 */
#ifndef LETOFF_CODEC_H
#define LETOFF_CODEC_H

#include "letoff_protocol.h"

/* Why bytes are not the frame that was asked for. */
enum letoff_refusal {
    LETOFF_TAKEN = 0,
    LETOFF_BAD_LENGTH,
    LETOFF_BAD_KIND,
    LETOFF_BAD_BOARD,
    LETOFF_BAD_VERSION,
    LETOFF_BAD_MAGIC,
    LETOFF_BAD_PADDING,
    LETOFF_BAD_VALUE
};

/* ---- The byte stream: frame, CRC, stuffing, closing zero. ---- */

uint16_t letoff_crc16(const uint8_t *bytes, size_t len);

/* Writes a frame as it travels; returns its length, at most LETOFF_MAX_WIRE, or 0 if it is longer
 * than LETOFF_MAX_FRAME. */
size_t letoff_wire(const uint8_t *frame, size_t len, uint8_t wire[LETOFF_MAX_WIRE]);

enum letoff_framing {
    LETOFF_NOTHING_YET = 0,
    LETOFF_FRAME,
    LETOFF_TOO_LONG,
    LETOFF_BAD_STUFFING,
    LETOFF_BAD_CHECKSUM
};

/* Finds frames in a stream; all zeros is its beginning. */
struct letoff_deframer {
    uint8_t buffer[LETOFF_MAX_WIRE];
    uint8_t n;
    bool overrun;
    /* Length of the frame in `buffer`, after LETOFF_FRAME and until the next byte. */
    uint8_t len;
};

enum letoff_framing letoff_deframe(struct letoff_deframer *deframer, uint8_t byte);

/* ---- CAN. ---- */

/* The 11-bit identifier of a frame; -1 if it is of no kind. */
int32_t letoff_can_id(const uint8_t *frame, size_t len);

/* The shortest CAN FD length that holds `len`; 64 for more than it can. */
size_t letoff_padded(size_t len);

/* How many pieces a frame takes on classic CAN. */
size_t letoff_pieces(size_t len);

/* Writes the piece `index` of a frame; returns its length, 0 if there is none. */
size_t letoff_cut(const uint8_t *frame, size_t len, uint8_t roll, size_t index, uint8_t piece[8]);

/* Puts the pieces of one sender together; all zeros is its beginning. */
struct letoff_assembler {
    uint8_t buffer[LETOFF_MAX_FRAME];
    uint8_t len;
    bool expecting;
    uint8_t roll;
    uint8_t index;
};

enum letoff_assembly { LETOFF_PIECE_TAKEN = 0, LETOFF_WHOLE, LETOFF_PIECE_LOST };

/* Takes the next piece; after LETOFF_WHOLE the frame is in `buffer`. */
enum letoff_assembly letoff_assemble(struct letoff_assembler *all, const uint8_t *piece, size_t len);

/* ---- Frames. ---- */

uint8_t letoff_kind(const uint8_t *frame);
uint8_t letoff_board(const uint8_t *frame);
uint8_t letoff_head(uint8_t kind, bool flag, uint8_t board);

struct letoff_header {
    uint8_t board;
    uint8_t sequence;
    uint16_t stamp_us;
    bool flag;
};

/* Bytes for one key; 0 for no packing. */
size_t letoff_samples_key_len(uint8_t packing);
size_t letoff_forces_key_len(uint8_t packing);

struct letoff_samples {
    struct letoff_header header;
    uint8_t packing;
    uint8_t n_keys;
    int32_t positions[LETOFF_MOST_KEYS];
    int16_t velocities[LETOFF_MOST_KEYS];
};

size_t letoff_samples_put(const struct letoff_samples *samples, uint8_t frame[LETOFF_MAX_FRAME]);
enum letoff_refusal letoff_samples_take(struct letoff_samples *samples, uint8_t packing,
                                        uint8_t n_keys, const uint8_t *frame, size_t len);

struct letoff_forces {
    struct letoff_header header;
    uint8_t packing;
    uint8_t n_keys;
    int16_t forces[LETOFF_MOST_KEYS];
    /* Codes of slopes, see letoff_slope(); zeros without. */
    uint8_t stiffness[LETOFF_MOST_KEYS];
    uint8_t damping[LETOFF_MOST_KEYS];
};

size_t letoff_forces_put(const struct letoff_forces *forces, uint8_t frame[LETOFF_MAX_FRAME]);
enum letoff_refusal letoff_forces_take(struct letoff_forces *forces, uint8_t packing,
                                       uint8_t n_keys, const uint8_t *frame, size_t len);

struct letoff_multicast {
    uint8_t group;
    uint8_t sequence;
    uint16_t stamp_us;
    bool flag;
    int16_t forces[LETOFF_MULTICAST_GROUP];
};

size_t letoff_multicast_put(const struct letoff_multicast *forces, uint8_t frame[LETOFF_MAX_FRAME]);
enum letoff_refusal letoff_multicast_take(struct letoff_multicast *forces, const uint8_t *frame,
                                          size_t len);

/* What is said to all; only the fields of `what` mean anything. */
struct letoff_broadcast {
    uint8_t what;
    uint8_t reason;
    uint32_t host_us;
    uint8_t major;
    uint8_t minor;
};

size_t letoff_broadcast_put(const struct letoff_broadcast *said,
                            uint8_t frame[LETOFF_BROADCAST_MAX_LEN]);
enum letoff_refusal letoff_broadcast_take(struct letoff_broadcast *said, const uint8_t *frame,
                                          size_t len);

/* A slope8: its value for a code, and the code next to a value on the side of zero. */
int32_t letoff_slope(uint8_t code);
uint8_t letoff_slope_code(int32_t units);

struct letoff_introduction {
    uint8_t board;
    bool safe;
    struct letoff_hello hello;
};

size_t letoff_introduction_put(const struct letoff_introduction *who,
                               uint8_t frame[LETOFF_MAX_FRAME]);
enum letoff_refusal letoff_introduction_take(struct letoff_introduction *who, const uint8_t *frame,
                                             size_t len);

/* The head of a request or reply; its record stands `record_len` bytes long at `record`. */
struct letoff_acyclic {
    uint8_t board;
    uint8_t id;
    uint8_t operation;
    /* Of replies; those of newer versions are LETOFF_STATUS_IMPOSSIBLE. */
    uint8_t status;
    const uint8_t *record;
    size_t record_len;
};

enum letoff_refusal letoff_request_take(struct letoff_acyclic *request, const uint8_t *frame,
                                        size_t len);
enum letoff_refusal letoff_reply_take(struct letoff_acyclic *reply, const uint8_t *frame,
                                      size_t len);

/* Write the head; the record is the caller's. Return its length. */
size_t letoff_request_head(uint8_t *frame, uint8_t board, uint8_t id, uint8_t operation);
size_t letoff_reply_head(uint8_t *frame, uint8_t board, uint8_t id, uint8_t operation,
                         uint8_t status);

#endif
