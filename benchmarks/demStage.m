% DEMSTAGE  The stage on DEM side by side: default and published.
%
% CALL: octave-cli benchmarks/demStage.m NAMES SEEDS CSV
%
%   NAMES  stand-ins (standIn), e.g. plain,silo
%   SEEDS  e.g. 1:20
%   CSV    table, to which one row a calibration is added
%
% Both ways of optim.method from the same plan. Right: the true means at the set that
% is handed back are within all tolerances (1 %, as a run scatters); a set of the
% published method is called met by its one run.
%
% See also: calibrateStandIn, calibrateOnDEM

1;

function cells = oneCase (name, method, seed)
  S = standIn (name, seed);
  r = calibrateStandIn (S, seed, 0, struct ('method', method));
  cells = {double(r.converged), double(r.right), 100 * r.worst, r.runs, ...
           r.infill + r.verify};
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
args = argv ();
fillTable (make_absolute_filename (args{3}), ...
           'case,method,seed,met,right,worst,runs,afterPlan', ...
           {strsplit(args{1}, ','), {'robust', 'published'}, ...
            str2num(['[', args{2}, ']'])}, @oneCase);

% SPDX-License-Identifier: GPL-3.0-only
