/* Reads the golden vectors named on the command line and holds the codec to them, both ways.
 *
 * Every line of a vector must be asked for: what nobody reads proves nothing.
 */
#include "../letoff_codec.h"

#include <stdio.h>
#include <stdlib.h>

#define LINES 40
#define VALUES 64
#define TEXT 1024

struct line {
    char name[32];
    char value[TEXT];
    bool used;
};

/* The vector that is being read. */
static const char *path;
static struct line lines[LINES];
static size_t n_lines;
static int failures;

static void fail(const char *what)
{
    fprintf(stderr, "%s: %s\n", path, what);
    failures++;
}

static bool read_lines(void)
{
    static char text[TEXT + 64];
    FILE *file = fopen(path, "r");
    n_lines = 0;
    while (file != NULL && n_lines < LINES && fgets(text, sizeof text, file) != NULL) {
        char *equals = strstr(text, " =");
        if (text[0] == '#' || equals == NULL) {
            continue;
        }
        struct line *line = &lines[n_lines++];
        text[strcspn(text, "\n")] = 0;
        *equals = 0;
        equals += 2;
        equals += strspn(equals, " ");
        snprintf(line->name, sizeof line->name, "%.31s", text);
        snprintf(line->value, sizeof line->value, "%.1000s", equals);
        line->used = false;
    }
    if (file != NULL) {
        fclose(file);
    }
    return n_lines != 0;
}

static const char *find(const char *name)
{
    for (size_t i = 0; i < n_lines; i++) {
        if (strcmp(lines[i].name, name) == 0) {
            lines[i].used = true;
            return lines[i].value;
        }
    }
    fail(name);
    return "";
}

/* The numbers of a line, in two's complement; returns how many. */
static size_t numbers(const char *name, uint64_t values[VALUES])
{
    const char *at = find(name);
    size_t n = 0;
    while (*at != 0 && n < VALUES) {
        char *end;
        values[n++] = *at == '-' ? 0u - strtoull(at + 1, &end, 10) : strtoull(at, &end, 10);
        at = end + strspn(end, " ");
    }
    return n;
}

static uint64_t number(const char *name)
{
    uint64_t values[VALUES] = {0};
    if (numbers(name, values) != 1) {
        fail(name);
    }
    return values[0];
}

static uint8_t small(const char *name)
{
    return (uint8_t)number(name);
}

/* One word of hex digits; returns what is behind it. */
static const char *hex(const char *at, uint8_t *bytes, size_t *len)
{
    *len = 0;
    for (; *at != 0 && *at != ' '; at += 2) {
        char digits[] = {at[0], at[1], 0};
        bytes[(*len)++] = (uint8_t)strtoul(digits, NULL, 16);
    }
    return at + strspn(at, " ");
}

static uint8_t golden[TEXT];
static size_t golden_len;

static void check_frame(const char *what, const uint8_t *frame, size_t len)
{
    if (len != golden_len || memcmp(frame, golden, len) != 0) {
        fail(what);
    }
}

static void check(const char *what, bool holds)
{
    if (!holds) {
        fail(what);
    }
}

static void check_bytes(const char *name, const uint8_t *bytes, size_t len)
{
    uint64_t values[VALUES];
    bool same = numbers(name, values) == len;
    for (size_t i = 0; same && i < len; i++) {
        same = values[i] == bytes[i];
    }
    check(name, same);
}

/* ---- Records. ---- */

#define ONE(field) check(#field, number(#field) == (uint64_t)record.field);
#define MANY(field, len) check_bytes(#field, record.field, len);
/* Reads a record behind `head` bytes, compares each field, and writes it there again. */
#define RECORD(type, head)                                                        \
    do {                                                                                  \
        struct letoff_##type record;                                                      \
        uint8_t again[LETOFF_MAX_FRAME];                                                  \
        check(#type, letoff_##type##_take(&record, golden + (head), golden_len - (head))); \
        LETOFF_FIELDS_##type(ONE, MANY)                                                   \
        memcpy(again, golden, (head));                                                    \
        size_t put = letoff_##type##_put(&record, again + (head), sizeof again - (head)); \
        check_frame(#type, again, (head) + put);                                          \
    } while (false)

/* A record without fields. */
struct letoff_nothing {
    bool none;
};

#define LETOFF_FIELDS_nothing(ONE, MANY)

static bool letoff_nothing_take(struct letoff_nothing *record, const uint8_t *bytes, size_t len)
{
    (void)bytes;
    record->none = true;
    return len == 0;
}

static size_t letoff_nothing_put(const struct letoff_nothing *record, uint8_t *bytes, size_t room)
{
    (void)bytes;
    (void)room;
    return record->none ? 0 : 1;
}

static void check_request(void)
{
    struct letoff_acyclic request;
    check("a request", letoff_request_take(&request, golden, golden_len) == LETOFF_TAKEN);
    check("board", request.board == small("board"));
    check("id", request.id == small("id"));
    check("operation", request.operation == small("operation"));
    uint8_t head[LETOFF_REQUEST_HEAD];
    letoff_request_head(head, request.board, request.id, request.operation);
    check("head", memcmp(head, golden, sizeof head) == 0);
#define CASE(NAME, function, request, answer)      \
    case LETOFF_OPERATION_##NAME:                  \
        RECORD(request, LETOFF_REQUEST_HEAD);      \
        break;
    switch (request.operation) {
        LETOFF_OPERATIONS(CASE)
#undef CASE
    default:
        check("nothing behind the head", request.record_len == 0);
    }
}

static void check_reply(void)
{
    struct letoff_acyclic reply;
    check("a reply", letoff_reply_take(&reply, golden, golden_len) == LETOFF_TAKEN);
    check("board", reply.board == small("board"));
    check("id", reply.id == small("id"));
    check("operation", reply.operation == small("operation"));
    check("status", reply.status == small("status"));
    uint8_t head[LETOFF_REPLY_HEAD];
    letoff_reply_head(head, reply.board, reply.id, reply.operation, reply.status);
    check("head", memcmp(head, golden, sizeof head) == 0);
#define CASE(NAME, function, request, answer)      \
    case LETOFF_OPERATION_##NAME:                  \
        RECORD(answer, LETOFF_REPLY_HEAD);         \
        break;
    switch (reply.status == LETOFF_STATUS_DONE ? reply.operation : 0) {
        LETOFF_OPERATIONS(CASE)
#undef CASE
    default:
        check("nothing behind the head", reply.record_len == 0);
    }
}

static void check_hello(void)
{
    struct letoff_introduction who;
    uint8_t again[LETOFF_MAX_FRAME];
    check("a hello", letoff_introduction_take(&who, golden, golden_len) == LETOFF_TAKEN);
    check("board", who.board == small("board"));
    check("flag", who.safe == (small("flag") == 1));
    RECORD(hello, 1u);
    check_frame("hello", again, letoff_introduction_put(&who, again));
}

/* ---- Cyclic frames and broadcasts. ---- */

static struct letoff_header header(void)
{
    struct letoff_header header;
    header.board = small("board");
    header.sequence = small("sequence");
    header.stamp_us = (uint16_t)number("stamp_us");
    header.flag = small("flag") == 1;
    return header;
}

static void check_samples(void)
{
    struct letoff_samples samples = {0};
    struct letoff_samples taken = {0};
    uint64_t values[VALUES];
    uint8_t again[LETOFF_MAX_FRAME];
    samples.header = header();
    samples.packing = small("packing");
    samples.n_keys = (uint8_t)numbers("positions", values);
    for (size_t i = 0; i < samples.n_keys; i++) {
        samples.positions[i] = letoff_signed(values[i], 32);
    }
    size_t moving = numbers("velocities", values);
    for (size_t i = 0; i < moving; i++) {
        samples.velocities[i] = (int16_t)letoff_signed(values[i], 16);
    }
    check_frame("written", again, letoff_samples_put(&samples, again));
    check("read", letoff_samples_take(&taken, samples.packing, samples.n_keys, golden,
                                      golden_len) == LETOFF_TAKEN);
    check("positions",
          memcmp(taken.positions, samples.positions, sizeof taken.positions) == 0);
    check("velocities",
          memcmp(taken.velocities, samples.velocities, sizeof taken.velocities) == 0);
    check_frame("written again", again, letoff_samples_put(&taken, again));
}

static void check_forces(void)
{
    struct letoff_forces forces = {0};
    struct letoff_forces taken = {0};
    uint64_t values[VALUES];
    uint8_t again[LETOFF_MAX_FRAME];
    forces.header = header();
    forces.packing = small("packing");
    forces.n_keys = (uint8_t)numbers("forces", values);
    for (size_t i = 0; i < forces.n_keys; i++) {
        forces.forces[i] = (int16_t)letoff_signed(values[i], 16);
    }
    size_t slopes = numbers("stiffness", values);
    for (size_t i = 0; i < slopes; i++) {
        forces.stiffness[i] = letoff_slope_code(letoff_signed(values[i], 32));
        check("stiffness", letoff_slope(forces.stiffness[i]) == letoff_signed(values[i], 32));
    }
    slopes = numbers("damping", values);
    for (size_t i = 0; i < slopes; i++) {
        forces.damping[i] = letoff_slope_code(letoff_signed(values[i], 32));
    }
    check_frame("written", again, letoff_forces_put(&forces, again));
    check("read", letoff_forces_take(&taken, forces.packing, forces.n_keys, golden, golden_len) ==
                      LETOFF_TAKEN);
    check("forces", memcmp(taken.forces, forces.forces, sizeof taken.forces) == 0);
    check_frame("written again", again, letoff_forces_put(&taken, again));
}

static void check_multicast(void)
{
    struct letoff_multicast forces = {0};
    struct letoff_multicast taken = {0};
    uint64_t values[VALUES];
    uint8_t again[LETOFF_MAX_FRAME];
    forces.group = small("group");
    forces.sequence = small("sequence");
    forces.stamp_us = (uint16_t)number("stamp_us");
    forces.flag = small("flag") == 1;
    check("forces", numbers("forces", values) == LETOFF_MULTICAST_GROUP);
    for (size_t i = 0; i < LETOFF_MULTICAST_GROUP; i++) {
        forces.forces[i] = (int16_t)letoff_signed(values[i], 16);
    }
    check_frame("written", again, letoff_multicast_put(&forces, again));
    check("read", letoff_multicast_take(&taken, golden, golden_len) == LETOFF_TAKEN);
    check_frame("written again", again, letoff_multicast_put(&taken, again));
}

static void check_broadcast(void)
{
    struct letoff_broadcast said = {0};
    struct letoff_broadcast taken;
    uint8_t again[LETOFF_BROADCAST_MAX_LEN];
    said.what = small("what");
    if (said.what == LETOFF_BROADCAST_STOP) {
        said.reason = small("reason");
    } else if (said.what == LETOFF_BROADCAST_TIME) {
        said.host_us = (uint32_t)number("host_us");
    } else {
        said.major = small("major");
        said.minor = small("minor");
    }
    check_frame("written", again, letoff_broadcast_put(&said, again));
    check("read", letoff_broadcast_take(&taken, golden, golden_len) == LETOFF_TAKEN);
    check_frame("written again", again, letoff_broadcast_put(&taken, again));
}

/* ---- Links. ---- */

static void check_links(void)
{
    static uint8_t wire[TEXT];
    size_t wire_len;
    uint8_t again[LETOFF_MAX_WIRE];
    hex(find("wire"), wire, &wire_len);
    size_t len = letoff_wire(golden, golden_len, again);
    check("wire", len == wire_len && memcmp(again, wire, len) == 0);
    struct letoff_deframer deframer = {0};
    enum letoff_framing last = LETOFF_NOTHING_YET;
    for (size_t i = 0; i < wire_len; i++) {
        check("an early frame", last == LETOFF_NOTHING_YET);
        last = letoff_deframe(&deframer, wire[i]);
    }
    check("deframed", last == LETOFF_FRAME);
    check_frame("deframed", deframer.buffer, deframer.len);
    check("can_id", letoff_can_id(golden, golden_len) == (int32_t)number("can_id"));
    check("padded", letoff_padded(golden_len) == (size_t)number("padded"));
}

static void check_pieces(void)
{
    struct letoff_assembler all = {0};
    enum letoff_assembly last = LETOFF_PIECE_TAKEN;
    uint8_t roll = small("roll");
    const char *at = find("pieces");
    size_t index = 0;
    for (; *at != 0; index++) {
        uint8_t piece[TEXT];
        uint8_t again[8];
        size_t len;
        at = hex(at, piece, &len);
        size_t cut = letoff_cut(golden, golden_len, roll, index, again);
        check("cut", cut == len && memcmp(piece, again, len) == 0);
        check("pieces", last == LETOFF_PIECE_TAKEN);
        last = letoff_assemble(&all, piece, len);
    }
    check("pieces", index == letoff_pieces(golden_len) && last == LETOFF_WHOLE);
    check_frame("assembled", all.buffer, all.len);
}

static void check_vector(void)
{
    static const struct {
        const char *kind;
        void (*check)(void);
    } kinds[] = {
        {"hello", check_hello},
        {"key_samples", check_samples},
        {"key_forces", check_forces},
        {"multicast_forces", check_multicast},
        {"broadcast", check_broadcast},
        {"request", check_request},
        {"reply", check_reply},
    };
    const char *kind = find("kind");
    bool known = false;
    hex(find("frame"), golden, &golden_len);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        if (strcmp(kind, kinds[i].kind) == 0) {
            kinds[i].check();
            known = true;
        }
    }
    check("a kind that nobody reads", known);
    check_links();
    check_pieces();
    for (size_t i = 0; i < n_lines; i++) {
        check(lines[i].name, lines[i].used);
    }
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        path = argv[i];
        if (read_lines()) {
            check_vector();
        } else {
            fail("cannot be read");
        }
    }
    printf("%d vectors, %d failures\n", argc - 1, failures);
    return failures == 0 && 1 < argc ? EXIT_SUCCESS : EXIT_FAILURE;
}
