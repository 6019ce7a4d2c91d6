from .dataset import read as read, to_dataset as to_dataset, write as write
from .models.experiment import load as load, loads as loads
from .study import Study as Study, prepare as prepare
