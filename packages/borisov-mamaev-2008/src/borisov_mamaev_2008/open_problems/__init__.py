"""What is decided of the open problems of §12: findings, and where they are computed."""
