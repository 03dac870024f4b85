% DEMSTAGE  The stage on DEM side by side: default and published.
%
% CALL: octave-cli benchmarks/demStage.m NAMES SEEDS CSV
%       octave-cli benchmarks/demStage.m report CSV
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
  if ~isfile (file)
    appendLine (file, 'case,method,seed,met,right,worst,runs,afterPlan');
  end
  [~, cells] = readCsvTable (file);
  done = strcat (cells(:, 1), ',', cells(:, 2), ',', cells(:, 3));
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

function report (file)
  [header, cells] = readCsvTable (file);
  M = str2double (cells(:, 3:end));
  col = @(name) M(:, strcmp (header(3:end), name));
  printf (['| stand-in | optim.method | n | called met | of them right | right | largest ', ...
           'true residual (%%): median, worst | runs, after the plan |\n', ...
           '|---|---|---|---|---|---|---|---|\n']);
  for name = unique (cells(:, 1), 'stable')'
    for method = {'robust', 'published'}
      here = strcmp (cells(:, 1), name{1}) & strcmp (cells(:, 2), method{1});
      of = @(column) col (column)(here);
      met = of ('met') == 1;
      printf ('| %s | %s | %d | %d | %d | %d | %.2g, %.2g | %.1f, %.1f |\n', name{1}, ...
              method{1}, sum (here), sum (met), sum (of ('right')(met)), ...
              sum (of ('right')), median (of ('worst')), max (of ('worst')), ...
              mean (of ('runs')), mean (of ('afterPlan')));
    end
  end
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
args = argv ();
if strcmp (args{1}, 'report')
  report (args{2});
else
  runStudy (strsplit (args{1}, ','), str2num (['[', args{2}, ']']), ...
            make_absolute_filename (args{3}));
end
