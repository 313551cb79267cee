/* What comes in goes to whom it concerns, and what is due goes out. */
#ifndef LINK_H
#define LINK_H

#include "acyclic.h"

/* All zeros is its beginning. */
struct link {
    struct letoff_deframer deframer;
    struct acyclic acyclic;
};

/* Takes one byte of the stream. */
void link_byte(struct link *link, struct state *state, uint8_t byte, uint32_t now_us);

/* Sends the hello if it is due. */
void link_hello(struct state *state, uint32_t now_us);

/* Sends samples if they are due; law and plant have run up to now. */
void link_samples(struct state *state, uint32_t now_us);

/* How long nothing is due to be sent [us], at most `most_us`. */
uint32_t link_idle(const struct state *state, uint32_t now_us, uint32_t most_us);

#endif
