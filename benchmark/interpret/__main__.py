"""`python -m c2s_bench.interpret [-v]`: how the learned reader does on the suite, by what is expected."""

import sys

from c2s_bench.interpret import suite


def main() -> None:
    """Print the table; with -v also what fails in the half that is for development."""
    results, times = suite.run()
    print(suite.table(results))
    print()
    print(suite.latency(times))
    if "-v" in sys.argv[1:]:
        for name, halves in results.items():
            print(f"\nFailures in {name}, develop:")
            for text, bad in halves["develop"].failures:
                print(f"- {text}\n    {'; '.join(bad)}")


if __name__ == "__main__":
    main()
