// Who may step when: bands of rows that take several steps, each by any thread, without a barrier.
//
// A step of a band reads the old copy of its neighbours' border rows and overwrites what they read
// a step before. Both are in order as soon as the band and its two neighbours have taken as many
// steps as it has. Tickets are drawn in the order of steps, then bands, so whatever a ticket waits
// for has been drawn before it: somebody is at work on it.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace melt
{
  class BandScheduler
  {
  public:
    /// `wraps`: the first and the last bands are neighbours.
    BandScheduler(int bands, bool wraps)
        : bands(bands), wraps(wraps), taken(static_cast<std::size_t>(bands))
    {
    }
    /// Back to the first step. By one thread while no other is in run().
    void start()
    {
      next = 0;
      for (Count &count : taken)
        count.steps = 0;
    }
    /// Called by every thread: work(band, step) for all bands and steps [0, steps).
    template <class Work>
    void run(const long steps, const Work &work)
    {
      for (long ticket; (ticket = next.fetch_add(1, std::memory_order_relaxed)) < steps * bands;)
      {
        const int band = static_cast<int>(ticket % bands);
        const long step = ticket / bands;
        for (const int near : {band - 1, band, band + 1})
          wait(near, step);
        // Across periodic sides, where the last band may hold no more than the row stored twice.
        if (wraps && (band == 0 || band >= bands - 2))
          for (const int near : {0, bands - 2, bands - 1})
            wait(near, step);
        work(band, step);
        taken[static_cast<std::size_t>(band)].steps.store(step + 1, std::memory_order_release);
      }
    }

  private:
    struct alignas(64) Count // each on its own cache line
    {
      std::atomic<long> steps{0};
    };
    void wait(const int band, const long step) const
    {
      if (band < 0 || band >= bands)
        return;
      const Count &count = taken[static_cast<std::size_t>(band)];
      for (int polls = 0; count.steps.load(std::memory_order_acquire) < step; ++polls)
        if (polls >= 1000) // another thread may need this core
          std::this_thread::yield();
    }

    int bands;
    bool wraps;
    std::atomic<long> next{0};
    std::vector<Count> taken;
  };
} // namespace melt
