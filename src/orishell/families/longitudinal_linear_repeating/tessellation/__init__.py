"""The flat tessellation: its columns and directions, and lengths that close all panels."""
