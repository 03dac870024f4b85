% REPORTPICTURES  Makes the pictures of the report that the README shows.
%
% CALL: octave-cli benchmarks/reportPictures.m [FOLDER]
%
%   FOLDER  case folder whose results/report.html is there already; default:
%           examples/hiddenEffect is calibrated and diagnosed in a new folder,
%           from the runs in examples/hiddenEffect/storedRuns.csv (no DEM run is
%           made; about 3 minutes)
%
% Writes docs/figures/report.png and docs/figures/report-gap.png with Chromium.
%
% See also: writePage

1;

function folder = diagnosedCase (root)
  folder = fullfile (tempname (), 'hiddenEffect');
  mkdir (fileparts (folder));
  mkdir (folder);
  example = fullfile (root, 'examples', 'hiddenEffect');
  copyfile (fullfile (example, '*.m'), folder);
  copyfile (fullfile (root, 'examples', 'hiddenEffect', 'storedRuns.csv'), ...
            fullfile (folder, 'runs.csv'));
  file = fullfile (folder, 'loadInput.m');
  text = regexprep (fileread (file), 'Input.maxNewRuns = \d+', ...
                    'Input.maxNewRuns = 0');
  writeAtomic (file, text);
  for script = {'DEcalioc.m', 'diagnoseGap.m'}
    startProgram (folder, shellQuote (fullfile (root, script{1})));
  end
end

function shoot (html, file, high)
  page = [tempname(), '.html'];
  writeAtomic (page, html);
  status = system (sprintf (['chromium --headless --no-sandbox ', ...
                             '--disable-gpu --hide-scrollbars ', ...
                             '--blink-settings=preferredColorScheme=1 ', ...
                             '--window-size=1180,%d --screenshot=%s ', ...
                             'file://%s 2> /dev/null'], high, ...
                            shellQuote (file), page));
  unlink (page);
  if status ~= 0
    error ('DEcalioc:reportPictures:runFailed', ...
           'reportPictures: chromium must take %s. Is it installed?', file);
  end
end

% The page with these sections alone.
function html = only (html, names)
  parts = regexp (html, '<section id="(\w+)".*?</section>', 'tokens');
  for k = 1:numel (parts)
    if ~any (strcmp (parts{k}{1}, names))
      html = regexprep (html, ['<section id="', parts{k}{1}, ...
                               '".*?</section>'], '', 'once');
    end
  end
end

root = fileparts (fileparts (mfilename ('fullpath')));
addpath (fullfile (root, 'benchmarks'));
startBenchmarks ();
if isempty (argv ())
  folder = diagnosedCase (root);
else
  folder = argv (){end};
end
html = fileread (fullfile (folder, 'results', 'report.html'));
figures = fullfile (root, 'docs', 'figures');
shoot (only (html, {'sectiontargets', 'sectionparameters'}), ...
       fullfile (figures, 'report.png'), 1250);
gap = regexprep (only (html, {'sectionwhich'}), ...
                 '<(header|nav)[ >].*?</(header|nav)>', '');
shoot (gap, fullfile (figures, 'report-gap.png'), 870);
