from .dataset import open_dataset as open_dataset, write_dataset as write_dataset
from .models.experiment import (
    load_experiment as load_experiment,
    parse_experiment as parse_experiment,
)
from .study import Study as Study
