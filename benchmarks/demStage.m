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

function runStudy (names, seeds, file)
  [done, counted] = startTable (file, ...
                                'case,method,seed,met,right,worst,runs,afterPlan', 3);
  methods = {'robust', 'published'};
  [m, n, s] = ndgrid (1:2, 1:numel (names), seeds);
  for k = 1:numel (m)
    key = sprintf ('%s,%s,%d', names{n(k)}, methods{m(k)}, s(k));
    if ~any (strcmp (done, key))
      appendLine (file, oneCase (names{n(k)}, methods{m(k)}, s(k)));
    end
  end
end

function line = oneCase (name, method, seed)
  S = standIn (name, seed);
  r = calibrateStandIn (S, seed, 0, struct ('method', method));
  line = rowText ({name, method, seed, double(r.converged), double(r.right), ...
                   100 * r.worst, r.runs, r.infill + r.verify});
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
args = argv ();
runStudy (strsplit (args{1}, ','), str2num (['[', args{2}, ']']), ...
          make_absolute_filename (args{3}));
