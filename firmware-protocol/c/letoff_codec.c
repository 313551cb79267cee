/* See letoff_codec.h. The layouts are those of the Rust crate's documentation. */
#include "letoff_codec.h"

#define CRC_LEN 2u
#define KIND_SHIFT 5u
#define FLAG_SHIFT 4u
#define BOARD_MASK 0x0Fu

/* ---- The byte stream. ---- */

uint16_t letoff_crc16(const uint8_t *bytes, size_t len)
{
    uint32_t crc = 0xFFFFu;
    for (size_t i = 0; i < len; i++) {
        /* Eight steps of the shift register at once. */
        uint32_t x = (crc >> 8 ^ bytes[i]) & 0xFFu;
        x ^= x >> 4;
        crc = (crc << 8 ^ x << 12 ^ x << 5 ^ x) & 0xFFFFu;
    }
    return (uint16_t)crc;
}

size_t letoff_wire(const uint8_t *frame, size_t len, uint8_t wire[LETOFF_MAX_WIRE])
{
    if (LETOFF_MAX_FRAME < len) {
        return 0;
    }
    uint16_t crc = letoff_crc16(frame, len);
    const uint8_t tail[CRC_LEN] = {(uint8_t)(crc & 0xFFu), (uint8_t)(crc >> 8)};
    /* Where the length of the present run goes. */
    size_t code_at = 0;
    size_t n = 1;
    for (size_t i = 0; i < len + CRC_LEN; i++) {
        uint8_t byte = i < len ? frame[i] : tail[i - len];
        if (byte != 0) {
            wire[n++] = byte;
        } else {
            wire[code_at] = (uint8_t)(n - code_at);
            code_at = n++;
        }
    }
    wire[code_at] = (uint8_t)(n - code_at);
    wire[n++] = 0;
    return n;
}

/* Undoes the stuffing in place; returns the length, or -1 if a run leaves the bytes. */
static int unstuff(uint8_t *bytes, size_t n)
{
    size_t from = 0;
    size_t to = 0;
    while (from < n) {
        size_t code = bytes[from];
        if (n < from + code) {
            return -1;
        }
        memmove(bytes + to, bytes + from + 1, code - 1u);
        to += code - 1u;
        from += code;
        /* The last run ends with the frame; any other with a zero, unless it is the longest. */
        if (from < n && code != 0xFFu) {
            bytes[to++] = 0;
        }
    }
    return (int)to;
}

static enum letoff_framing open_frame(struct letoff_deframer *deframer, size_t n)
{
    int body = unstuff(deframer->buffer, n);
    if (body < 0) {
        return LETOFF_BAD_STUFFING;
    }
    if ((size_t)body < CRC_LEN) {
        return LETOFF_BAD_CHECKSUM;
    }
    size_t len = (size_t)body - CRC_LEN;
    if (letoff_take(deframer->buffer + len, CRC_LEN) != letoff_crc16(deframer->buffer, len)) {
        return LETOFF_BAD_CHECKSUM;
    }
    deframer->len = (uint8_t)len;
    return LETOFF_FRAME;
}

enum letoff_framing letoff_deframe(struct letoff_deframer *deframer, uint8_t byte)
{
    if (byte != 0) {
        /* The last place is the closing zero's, which is never kept. */
        if (deframer->n < LETOFF_MAX_WIRE - 1u) {
            deframer->buffer[deframer->n++] = byte;
        } else {
            deframer->overrun = true;
        }
        return LETOFF_NOTHING_YET;
    }
    size_t n = deframer->n;
    bool overrun = deframer->overrun;
    deframer->n = 0;
    deframer->overrun = false;
    if (overrun) {
        return LETOFF_TOO_LONG;
    }
    return n == 0 ? LETOFF_NOTHING_YET : open_frame(deframer, n);
}

/* ---- CAN. ---- */

int32_t letoff_can_id(const uint8_t *frame, size_t len)
{
    /* By kind; a broadcast that stops everything is of a class of its own. */
    static const uint8_t classes[] = {
        LETOFF_CLASS_SYNC,    LETOFF_CLASS_KEY_FORCES, LETOFF_CLASS_MULTICAST_FORCES,
        LETOFF_CLASS_KEY_SAMPLES, LETOFF_CLASS_REQUEST, LETOFF_CLASS_REPLY,
        LETOFF_CLASS_HELLO,
    };
    if (len == 0 || sizeof classes <= letoff_kind(frame)) {
        return -1;
    }
    uint32_t class = classes[letoff_kind(frame)];
    uint32_t node = letoff_board(frame);
    if (class == LETOFF_CLASS_SYNC && 1 < len && frame[1] == LETOFF_BROADCAST_STOP) {
        class = LETOFF_CLASS_STOP;
    }
    if (class == LETOFF_CLASS_MULTICAST_FORCES) {
        node = LETOFF_ALL_BOARDS;
    }
    return (int32_t)(class << LETOFF_CAN_CLASS_SHIFT | node);
}

size_t letoff_padded(size_t len)
{
    static const uint8_t lengths[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64};
    for (size_t i = 0; i < sizeof lengths; i++) {
        if (len <= lengths[i]) {
            return lengths[i];
        }
    }
    return LETOFF_MAX_FRAME;
}

size_t letoff_pieces(size_t len)
{
    size_t kept = len < LETOFF_MAX_FRAME ? len : LETOFF_MAX_FRAME;
    return kept == 0 ? 1 : (kept + LETOFF_PIECE - 1u) / LETOFF_PIECE;
}

size_t letoff_cut(const uint8_t *frame, size_t len, uint8_t roll, size_t index, uint8_t piece[8])
{
    size_t kept = len < LETOFF_MAX_FRAME ? len : LETOFF_MAX_FRAME;
    size_t n = letoff_pieces(kept);
    if (n <= index) {
        return 0;
    }
    size_t at = index * LETOFF_PIECE;
    size_t part = kept - at < LETOFF_PIECE ? kept - at : LETOFF_PIECE;
    uint32_t last = index + 1u == n ? LETOFF_PIECE_LAST : 0u;
    uint32_t head = (uint32_t)roll << LETOFF_PIECE_ROLL_SHIFT | last | (uint32_t)index;
    piece[0] = (uint8_t)(head & 0xFFu);
    memcpy(piece + 1, frame + at, part);
    return part + 1u;
}

static enum letoff_assembly lose(struct letoff_assembler *all)
{
    all->expecting = false;
    return LETOFF_PIECE_LOST;
}

enum letoff_assembly letoff_assemble(struct letoff_assembler *all, const uint8_t *piece, size_t len)
{
    if (len == 0) {
        return lose(all);
    }
    uint8_t roll = (uint8_t)(piece[0] >> LETOFF_PIECE_ROLL_SHIFT);
    uint8_t index = piece[0] & LETOFF_PIECE_INDEX;
    bool begins = index == 0;
    if (!begins && !(all->expecting && all->roll == roll && all->index == index)) {
        return lose(all);
    }
    bool interrupted = begins && all->expecting;
    if (begins) {
        all->len = 0;
    }
    size_t part = len - 1u;
    if (LETOFF_MAX_FRAME - all->len < part) {
        return lose(all);
    }
    memcpy(all->buffer + all->len, piece + 1, part);
    all->len = (uint8_t)(all->len + part);
    all->roll = roll;
    all->index = (uint8_t)((index + 1u) & LETOFF_PIECE_INDEX);
    all->expecting = (piece[0] & LETOFF_PIECE_LAST) == 0;
    if (!all->expecting) {
        return LETOFF_WHOLE;
    }
    return interrupted ? LETOFF_PIECE_LOST : LETOFF_PIECE_TAKEN;
}

/* ---- What all frames share. ---- */

uint8_t letoff_kind(const uint8_t *frame)
{
    return (uint8_t)(frame[0] >> KIND_SHIFT);
}

uint8_t letoff_board(const uint8_t *frame)
{
    return frame[0] & BOARD_MASK;
}

uint8_t letoff_head(uint8_t kind, bool flag, uint8_t board)
{
    uint32_t head = (uint32_t)kind << KIND_SHIFT | (board & BOARD_MASK);
    return (uint8_t)((flag ? head | 1u << FLAG_SHIFT : head) & 0xFFu);
}

static bool flag_of(const uint8_t *frame)
{
    return (frame[0] >> FLAG_SHIFT & 1u) != 0;
}

static bool all_zero(const uint8_t *bytes, size_t len)
{
    for (size_t i = 0; i < len; i++) {
        if (bytes[i] != 0) {
            return false;
        }
    }
    return true;
}

/* Checks the kind of a frame that is not empty, and that one board is meant. */
static enum letoff_refusal check_board(const uint8_t *frame, uint8_t kind)
{
    if (letoff_kind(frame) != kind) {
        return LETOFF_BAD_KIND;
    }
    return LETOFF_MAX_BOARD < letoff_board(frame) ? LETOFF_BAD_BOARD : LETOFF_TAKEN;
}

/* Reads the header of a cyclic frame with exactly `values` bytes behind it, and padding. */
static enum letoff_refusal take_header(struct letoff_header *header, uint8_t kind, size_t values,
                                       const uint8_t *frame, size_t len)
{
    if (len < LETOFF_HEADER_LEN) {
        return LETOFF_BAD_LENGTH;
    }
    enum letoff_refusal refusal = check_board(frame, kind);
    if (refusal != LETOFF_TAKEN) {
        return refusal;
    }
    size_t whole = LETOFF_HEADER_LEN + values;
    if (len < whole || letoff_padded(whole) < len) {
        return LETOFF_BAD_LENGTH;
    }
    if (!all_zero(frame + whole, len - whole)) {
        return LETOFF_BAD_PADDING;
    }
    header->board = letoff_board(frame);
    header->flag = flag_of(frame);
    header->sequence = frame[1];
    header->stamp_us = (uint16_t)letoff_take(frame + 2, 2);
    return LETOFF_TAKEN;
}

static void put_header(const struct letoff_header *header, uint8_t kind, uint8_t *frame)
{
    frame[0] = letoff_head(kind, header->flag, header->board);
    frame[1] = header->sequence;
    letoff_put(frame + 2, header->stamp_us, 2);
}

static int32_t clamp(int32_t value, int32_t least, int32_t most)
{
    return value < least ? least : most < value ? most : value;
}

static uint8_t keys_kept(uint8_t n_keys)
{
    return n_keys < LETOFF_MOST_KEYS ? n_keys : LETOFF_MOST_KEYS;
}

/* ---- Samples. ---- */

static size_t position_len(uint8_t packing)
{
    bool is_short =
        packing == LETOFF_SAMPLES_POSITION16 || packing == LETOFF_SAMPLES_POSITION16_VELOCITY;
    return is_short ? 2 : 3;
}

static bool has_velocity(uint8_t packing)
{
    return packing == LETOFF_SAMPLES_POSITION16_VELOCITY ||
           packing == LETOFF_SAMPLES_POSITION24_VELOCITY;
}

size_t letoff_samples_key_len(uint8_t packing)
{
    if (LETOFF_SAMPLES_POSITION24_VELOCITY < packing) {
        return 0;
    }
    return position_len(packing) + (has_velocity(packing) ? 2u : 0u);
}

size_t letoff_samples_put(const struct letoff_samples *samples, uint8_t frame[LETOFF_MAX_FRAME])
{
    size_t size = letoff_samples_key_len(samples->packing);
    size_t wide = position_len(samples->packing);
    int32_t most = wide == 2 ? INT16_MAX : LETOFF_MAX_COUNTS;
    memset(frame, 0, LETOFF_MAX_FRAME);
    put_header(&samples->header, LETOFF_KIND_KEY_SAMPLES, frame);
    uint8_t *at = frame + LETOFF_HEADER_LEN;
    for (size_t i = 0; i < keys_kept(samples->n_keys); i++, at += size) {
        letoff_put(at, (uint64_t)clamp(samples->positions[i], -most - 1, most), wide);
        if (has_velocity(samples->packing)) {
            letoff_put(at + wide, (uint64_t)samples->velocities[i], 2);
        }
    }
    return (size_t)(at - frame);
}

enum letoff_refusal letoff_samples_take(struct letoff_samples *samples, uint8_t packing,
                                        uint8_t n_keys, const uint8_t *frame, size_t len)
{
    size_t size = letoff_samples_key_len(packing);
    size_t wide = position_len(packing);
    if (size == 0 || LETOFF_MOST_KEYS < n_keys) {
        return LETOFF_BAD_VALUE;
    }
    enum letoff_refusal refusal =
        take_header(&samples->header, LETOFF_KIND_KEY_SAMPLES, n_keys * size, frame, len);
    if (refusal != LETOFF_TAKEN) {
        return refusal;
    }
    samples->packing = packing;
    samples->n_keys = n_keys;
    const uint8_t *at = frame + LETOFF_HEADER_LEN;
    for (size_t i = 0; i < n_keys; i++, at += size) {
        samples->positions[i] = letoff_signed(letoff_take(at, wide), (unsigned)(8u * wide));
        samples->velocities[i] =
            has_velocity(packing) ? (int16_t)letoff_signed(letoff_take(at + wide, 2), 16) : 0;
    }
    return LETOFF_TAKEN;
}

/* ---- Forces. ---- */

size_t letoff_forces_key_len(uint8_t packing)
{
    switch (packing) {
    case LETOFF_FORCES_FORCE16:
    case LETOFF_FORCES_MULTICAST16:
        return 2;
    case LETOFF_FORCES_FORCE16_SLOPE:
        return 4;
    default:
        return 0;
    }
}

size_t letoff_forces_put(const struct letoff_forces *forces, uint8_t frame[LETOFF_MAX_FRAME])
{
    size_t size = letoff_forces_key_len(forces->packing);
    memset(frame, 0, LETOFF_MAX_FRAME);
    put_header(&forces->header, LETOFF_KIND_KEY_FORCES, frame);
    uint8_t *at = frame + LETOFF_HEADER_LEN;
    for (size_t i = 0; i < keys_kept(forces->n_keys); i++, at += size) {
        letoff_put(at, (uint64_t)forces->forces[i], 2);
        if (size == 4) {
            at[2] = forces->stiffness[i];
            at[3] = forces->damping[i];
        }
    }
    return (size_t)(at - frame);
}

enum letoff_refusal letoff_forces_take(struct letoff_forces *forces, uint8_t packing,
                                       uint8_t n_keys, const uint8_t *frame, size_t len)
{
    size_t size = letoff_forces_key_len(packing);
    if (size == 0 || LETOFF_MOST_KEYS < n_keys) {
        return LETOFF_BAD_VALUE;
    }
    enum letoff_refusal refusal =
        take_header(&forces->header, LETOFF_KIND_KEY_FORCES, n_keys * size, frame, len);
    if (refusal != LETOFF_TAKEN) {
        return refusal;
    }
    forces->packing = packing;
    forces->n_keys = n_keys;
    const uint8_t *at = frame + LETOFF_HEADER_LEN;
    for (size_t i = 0; i < n_keys; i++, at += size) {
        forces->forces[i] = (int16_t)letoff_signed(letoff_take(at, 2), 16);
        forces->stiffness[i] = size == 4 ? at[2] : 0;
        forces->damping[i] = size == 4 ? at[3] : 0;
    }
    return LETOFF_TAKEN;
}

size_t letoff_multicast_put(const struct letoff_multicast *forces, uint8_t frame[LETOFF_MAX_FRAME])
{
    frame[0] = letoff_head(LETOFF_KIND_MULTICAST_FORCES, forces->flag, forces->group);
    frame[1] = forces->sequence;
    letoff_put(frame + 2, forces->stamp_us, 2);
    for (size_t i = 0; i < LETOFF_MULTICAST_GROUP; i++) {
        letoff_put(frame + LETOFF_HEADER_LEN + 2 * i, (uint64_t)forces->forces[i], 2);
    }
    return LETOFF_MAX_FRAME;
}

enum letoff_refusal letoff_multicast_take(struct letoff_multicast *forces, const uint8_t *frame,
                                          size_t len)
{
    if (len != LETOFF_MAX_FRAME) {
        return LETOFF_BAD_LENGTH;
    }
    if (letoff_kind(frame) != LETOFF_KIND_MULTICAST_FORCES) {
        return LETOFF_BAD_KIND;
    }
    if (LETOFF_MULTICAST_GROUPS <= letoff_board(frame)) {
        return LETOFF_BAD_VALUE;
    }
    forces->group = letoff_board(frame);
    forces->flag = flag_of(frame);
    forces->sequence = frame[1];
    forces->stamp_us = (uint16_t)letoff_take(frame + 2, 2);
    for (size_t i = 0; i < LETOFF_MULTICAST_GROUP; i++) {
        uint64_t raw = letoff_take(frame + LETOFF_HEADER_LEN + 2 * i, 2);
        forces->forces[i] = (int16_t)letoff_signed(raw, 16);
    }
    return LETOFF_TAKEN;
}

int32_t letoff_slope(uint8_t code)
{
    int32_t exponent = code >> 3 & 0xF;
    int32_t mantissa = code & 7;
    /* At most 15 << 14. */
    int32_t magnitude =
        exponent == 0 ? mantissa : (int32_t)((uint32_t)(8 + mantissa) << (exponent - 1));
    return (code & 0x80u) == 0 ? magnitude : -magnitude;
}

uint8_t letoff_slope_code(int32_t units)
{
    uint32_t magnitude = units < 0 ? 0u - (uint32_t)units : (uint32_t)units;
    if ((uint32_t)LETOFF_MAX_SLOPE < magnitude) {
        magnitude = (uint32_t)LETOFF_MAX_SLOPE;
    }
    uint32_t exponent = magnitude < 8 ? 0u : 1u;
    while (15u < magnitude) {
        magnitude >>= 1;
        exponent++;
    }
    uint32_t code = exponent << 3 | (magnitude & 7u);
    return (uint8_t)(units < 0 ? code | 0x80u : code);
}

/* ---- What is said to all. ---- */

size_t letoff_broadcast_put(const struct letoff_broadcast *said,
                            uint8_t frame[LETOFF_BROADCAST_MAX_LEN])
{
    memset(frame, 0, LETOFF_BROADCAST_MAX_LEN);
    frame[0] = letoff_head(LETOFF_KIND_BROADCAST, false, LETOFF_ALL_BOARDS);
    frame[1] = said->what;
    switch (said->what) {
    case LETOFF_BROADCAST_STOP:
        frame[2] = LETOFF_STOP_MAGIC_0;
        frame[3] = LETOFF_STOP_MAGIC_1;
        frame[4] = said->reason;
        return 5;
    case LETOFF_BROADCAST_TIME:
        letoff_put(frame + 2, said->host_us, 4);
        return 6;
    default:
        frame[2] = said->major;
        frame[3] = said->minor;
        return 4;
    }
}

/* Length of a broadcast without padding; 0 for one that this version does not know. */
static size_t broadcast_len(uint8_t what)
{
    switch (what) {
    case LETOFF_BROADCAST_STOP:
        return 5;
    case LETOFF_BROADCAST_TIME:
        return 6;
    case LETOFF_BROADCAST_WHO:
        return 4;
    default:
        return 0;
    }
}

enum letoff_refusal letoff_broadcast_take(struct letoff_broadcast *said, const uint8_t *frame,
                                          size_t len)
{
    if (len < 2 || LETOFF_BROADCAST_MAX_LEN < len) {
        return LETOFF_BAD_LENGTH;
    }
    if (letoff_kind(frame) != LETOFF_KIND_BROADCAST) {
        return LETOFF_BAD_KIND;
    }
    size_t whole = broadcast_len(frame[1]);
    if (letoff_board(frame) != LETOFF_ALL_BOARDS || whole == 0) {
        return LETOFF_BAD_VALUE;
    }
    if (len < whole) {
        return LETOFF_BAD_LENGTH;
    }
    memset(said, 0, sizeof *said);
    said->what = frame[1];
    if (said->what == LETOFF_BROADCAST_STOP) {
        if (frame[2] != LETOFF_STOP_MAGIC_0 || frame[3] != LETOFF_STOP_MAGIC_1) {
            return LETOFF_BAD_MAGIC;
        }
        said->reason = frame[4];
    } else if (said->what == LETOFF_BROADCAST_TIME) {
        said->host_us = (uint32_t)letoff_take(frame + 2, 4);
    } else {
        said->major = frame[2];
        said->minor = frame[3];
    }
    return all_zero(frame + whole, len - whole) ? LETOFF_TAKEN : LETOFF_BAD_PADDING;
}

/* ---- Hello, requests, replies. ---- */

size_t letoff_introduction_put(const struct letoff_introduction *who,
                               uint8_t frame[LETOFF_MAX_FRAME])
{
    memset(frame, 0, LETOFF_MAX_FRAME);
    frame[0] = letoff_head(LETOFF_KIND_HELLO, who->safe, who->board);
    return 1u + letoff_hello_put(&who->hello, frame + 1, LETOFF_MAX_FRAME - 1u);
}

enum letoff_refusal letoff_introduction_take(struct letoff_introduction *who, const uint8_t *frame,
                                             size_t len)
{
    static const uint8_t magic[] = {
        LETOFF_MAGIC_0, LETOFF_MAGIC_1, LETOFF_MAGIC_2, LETOFF_MAGIC_3
    };
    if (len == 0 || LETOFF_MAX_FRAME < len) {
        return LETOFF_BAD_LENGTH;
    }
    enum letoff_refusal refusal = check_board(frame, LETOFF_KIND_HELLO);
    if (refusal != LETOFF_TAKEN) {
        return refusal;
    }
    if (len < 2u + sizeof magic) {
        return LETOFF_BAD_LENGTH;
    }
    if (memcmp(frame + 1, magic, sizeof magic) != 0) {
        return LETOFF_BAD_MAGIC;
    }
    if (frame[1u + LETOFF_HELLO_MAJOR_AT] != LETOFF_VERSION_MAJOR) {
        return LETOFF_BAD_VERSION;
    }
    who->board = letoff_board(frame);
    who->safe = flag_of(frame);
    bool whole = letoff_hello_take(&who->hello, frame + 1, len - 1u);
    return whole ? LETOFF_TAKEN : LETOFF_BAD_LENGTH;
}

static enum letoff_refusal take_acyclic(struct letoff_acyclic *acyclic, uint8_t kind, size_t head,
                                        const uint8_t *frame, size_t len)
{
    if (len < head || LETOFF_MAX_FRAME < len) {
        return LETOFF_BAD_LENGTH;
    }
    enum letoff_refusal refusal = check_board(frame, kind);
    if (refusal != LETOFF_TAKEN) {
        return refusal;
    }
    acyclic->board = letoff_board(frame);
    acyclic->id = frame[1];
    acyclic->operation = frame[2];
    acyclic->status = LETOFF_STATUS_DONE;
    acyclic->record = frame + head;
    acyclic->record_len = len - head;
    return LETOFF_TAKEN;
}

enum letoff_refusal letoff_request_take(struct letoff_acyclic *request, const uint8_t *frame,
                                        size_t len)
{
    return take_acyclic(request, LETOFF_KIND_REQUEST, LETOFF_REQUEST_HEAD, frame, len);
}

enum letoff_refusal letoff_reply_take(struct letoff_acyclic *reply, const uint8_t *frame,
                                      size_t len)
{
    enum letoff_refusal refusal =
        take_acyclic(reply, LETOFF_KIND_REPLY, LETOFF_REPLY_HEAD, frame, len);
    if (refusal == LETOFF_TAKEN) {
        uint8_t status = frame[3];
        reply->status =
            LETOFF_STATUS_IMPOSSIBLE < status ? (uint8_t)LETOFF_STATUS_IMPOSSIBLE : status;
    }
    return refusal;
}

size_t letoff_request_head(uint8_t *frame, uint8_t board, uint8_t id, uint8_t operation)
{
    frame[0] = letoff_head(LETOFF_KIND_REQUEST, false, board);
    frame[1] = id;
    frame[2] = operation;
    return LETOFF_REQUEST_HEAD;
}

size_t letoff_reply_head(uint8_t *frame, uint8_t board, uint8_t id, uint8_t operation,
                         uint8_t status)
{
    frame[0] = letoff_head(LETOFF_KIND_REPLY, false, board);
    frame[1] = id;
    frame[2] = operation;
    frame[3] = status;
    return LETOFF_REPLY_HEAD;
}
