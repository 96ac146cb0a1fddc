"""What is typed to change a scene: demands become edits of S."""
