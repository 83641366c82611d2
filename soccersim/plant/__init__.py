"""What is so: motors, wheels on the floor, the ball, and the bodies that meet."""
