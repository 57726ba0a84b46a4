"""The algorithms on the chain of links, written once over blocks and small matrices."""
