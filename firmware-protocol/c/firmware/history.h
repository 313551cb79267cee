/* The last frames of samples that were sent: what forces answer. */
#ifndef HISTORY_H
#define HISTORY_H

#include "../letoff_protocol.h"

struct history_entry {
    /* When the encoders were read. */
    uint32_t board_us;
    uint8_t sequence;
    bool there;
    /* An answer is expected, and has come. */
    bool owed;
    bool answered;
    int32_t counts[LETOFF_MOST_KEYS];
    /* [m/s]; what the packing of the samples leaves out is known here all the same. */
    float velocities[LETOFF_MOST_KEYS];
};

/* All zeros is its beginning. */
struct history {
    struct history_entry entries[LETOFF_HISTORY];
    uint8_t next;
};

/* The place of the next frame, with its number and time; says whether the oldest, which had been
 * there, was never answered. */
struct history_entry *history_add(struct history *history, uint32_t board_us, bool *unanswered);

/* The frame with this number and time, if it is one of the last; else NULL. */
struct history_entry *history_find(struct history *history, uint8_t sequence, uint16_t stamp_us);

#endif
