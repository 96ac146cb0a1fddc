"""What somebody does who is only named, where no verb that tells more stands before it: a participle behind a comma
("van ahead, braking hard", "got a cyclist on the left, swerving"), a verb behind a colon ("van ahead: brakes")."""

from __future__ import annotations
