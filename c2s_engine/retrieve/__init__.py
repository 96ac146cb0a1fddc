"""The snippet and documentation stores and the dual retriever; all that needs torch or LanceDB runs in the worker."""
