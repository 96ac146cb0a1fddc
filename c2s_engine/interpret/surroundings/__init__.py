"""What is around: the road as told, weather and light, settings, and words of place."""
