from tests.models.fixtures import client_of, server

__all__ = ["client_of", "server"]
