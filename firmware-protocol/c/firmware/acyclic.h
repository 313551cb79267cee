/* Requests, one function each, and the answer that was given last. */
#ifndef ACYCLIC_H
#define ACYCLIC_H

#include "../letoff_codec.h"
#include "state.h"

/* The reply that was sent last; all zeros is its beginning. */
struct acyclic {
    bool answered;
    uint8_t len;
    uint8_t reply[LETOFF_MAX_FRAME];
};

/* Does what is asked for, unless it was the request before; the reply is in `acyclic` then. */
void acyclic_answer(struct acyclic *acyclic, struct state *state,
                    const struct letoff_acyclic *request, uint32_t now_us);

#endif
