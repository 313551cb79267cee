#include "history.h"

struct history_entry *history_add(struct history *history, uint32_t board_us, bool *unanswered)
{
    /* 64 divides 256: each number has one place, also across the wrap. */
    struct history_entry *entry = &history->entries[history->next % LETOFF_HISTORY];
    *unanswered = entry->there && entry->owed && !entry->answered;
    memset(entry, 0, sizeof *entry);
    entry->there = true;
    entry->sequence = history->next;
    entry->board_us = board_us;
    history->next++;
    return entry;
}

struct history_entry *history_find(struct history *history, uint8_t sequence, uint16_t stamp_us)
{
    struct history_entry *entry = &history->entries[sequence % LETOFF_HISTORY];
    bool same = entry->there && entry->sequence == sequence &&
                (entry->board_us & 0xFFFFu) == stamp_us;
    return same ? entry : NULL;
}
