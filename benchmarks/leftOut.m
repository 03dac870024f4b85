% LEFTOUT  Diagnoses real runs that were left out of their own campaign.
%
% CALL: octave-cli benchmarks/leftOut.m [hiddenEffect|drumAndBins ...] [every]
%
% Each run of a stored campaign on LIGGGHTS (storedRuns.csv of its folder) is
% left out once with all its repeats and, with measurement noise added, taken
% for the measurement: rows with one effect tell whether it is named and whether
% its strength is found, rows with two the same for pairs, neutral rows how
% often there is a false alarm. The truth is a run of the DEM program, not of
% the surrogates that diagnose it. With a number as last argument only every
% n-th row is taken.
%
% Writes results/leftOut-<name>.csv, a row a case; make figures counts them. A sample, or one
% campaign alone, is written to a folder below TMPDIR, which it says: tables that
% are published come of all rows.
%
% See also: foreignTwins, leftOutCase, gapTables

1;

function runLeftOut (names, every)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  results = resultsFolder (root, names, every);
  for name = names
    campaign = leftOutCampaign (name{1}, root);
    rows_ = 1:every:rows (campaign.data.Z);
    jobs = num2cell (rows_(campaign.isWhole(rows_)));
    printf ('%s: %d runs are left out, one after the other\n', name{1}, ...
            numel (jobs));
    edges = round (linspace (0, numel (jobs), nproc () + 1));
    shares = mat2cell ([jobs{:}], 1, diff (edges));
    parts = parcellfun (nproc (), @leftOutCase, ...
                        repmat ({campaign}, 1, numel (shares)), shares, ...
                        'UniformOutput', false, 'VerboseLevel', 0);
    writeCases (fullfile (results, ['leftOut-', name{1}, '.csv']), [parts{:}]);
  end
  printf ('Figures: make figures\n');
end

function folder = resultsFolder (root, names, every)
  folder = fullfile (root, 'benchmarks', 'results');
  if every > 1 || ~all (ismember ({'hiddenEffect', 'drumAndBins'}, names))
    folder = tempname ();
    mkdir (folder);
    printf ('A sample: written to %s\n', folder);
  end
end

function writeCases (file, cases)
  lines = {['campaign,row,class,cause,phi,d,verdict,effects,lookAlike,' ...
            'guard,top,pTop,pTrue,pNull,strength,lo90,hi90,gateP,ess']};
  for c = cases
    lines{end + 1} = sprintf ...
      (['%s,%d,%s,%s,%s,%.2f,%s,%s,%d,%s,%s,%.4f,%.4f,%.4f,%.3f,%.3f,' ...
        '%.3f,%.4f,%.0f'], ...
       c.campaign, c.row, c.class, strjoin (c.cause, ' '), ...
       strtrim (sprintf ('%.3f ', c.phi)), c.d, c.verdict, ...
       strjoin (c.effects, ' '), c.lookAlike, c.guard, c.top, c.pTop, ...
       c.pTrue, c.pNull, c.interval, c.gateP, c.ess);
  end
  writeTable (file, lines);
end

args = argv ();
every = 1;
if ~isempty (args) && isfinite (str2double (args{end}))
  every = str2double (args{end});
  args(end) = [];
end
if isempty (args)
  args = {'hiddenEffect', 'drumAndBins'};
end
runLeftOut (args(:)', every);

% SPDX-License-Identifier: GPL-3.0-only
