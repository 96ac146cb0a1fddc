"""The retrieval benchmark: graded queries, and what the retrievers make of them."""
