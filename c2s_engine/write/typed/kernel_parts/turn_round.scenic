behavior TurnRound(speed=4):
    """Turn left on the spot until the car faces the way that it came from."""
    begin = self.heading
    while math.cos(self.heading - begin) > -0.94:
        take SetSpeedAction(speed), SetSteerAction(-0.55)
