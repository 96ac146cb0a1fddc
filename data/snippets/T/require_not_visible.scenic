# component: T
# description: At the start ego cannot see the vehicle behind it.
# paraphrases:
#   - outside the field of view
#   - hidden from the host initially
#   - out of sight at the beginning
# conditions: [not_visible]
# hosts: [O/follower_behind]
# ---
require not (ego can see tail)
