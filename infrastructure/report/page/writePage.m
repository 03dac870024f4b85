% WRITEPAGE  Writes the report of a case: results/report.html, one file.
%
% CALL: FILE = writePage (CASE)
%
%   CASE  see newCase; finished, under way, or not begun
%   FILE  path of the page (text)
%
% Made of the files in the case folder alone: nothing is run or evaluated. The
% page needs no network and no other file. results/runTable.csv is written too,
% a row a run: model, folder, stage, status, cause, replicate, seed, seconds,
% started (s since 1970), the design variables, the effect variables, the
% targets (empty where the run has no such result), message.
%
% A part that cannot be drawn says so and leaves the others alone.

function file = writePage (Case)
  page = pageData (Case);
  folder = fullfile (Case.folder, 'results');
  [~, ~] = mkdir (folder);
  writeRunTable (page);
  [links, parts] = sectionsOf (page);
  [verdict, word] = pageVerdict (page);
  style = fullfile (fileparts (mfilename ('fullpath')), 'page.css');
  html = {"<!DOCTYPE html>\n", '<html lang="en"><head>', ...
          '<meta charset="utf-8">', ...
          '<meta http-equiv="Content-Security-Policy" ', ...
          'content="default-src ''none''; style-src ''unsafe-inline''; ', ...
          'img-src data:">', ...
          '<meta name="viewport" content="width=device-width, ', ...
          'initial-scale=1">', ...
          '<meta name="generator" content="DEcalioc">', ...
          '<title>', htmlText([word, ': ', caseName(Case)]), ...
          "</title>\n<style>\n", fileread(style), "</style>\n</head>\n", ...
          '<body><a class="skip" href="#main">To the content</a>', "\n", ...
          houseSymbols(), headerOf(page, verdict), ...
          '<nav aria-label="Contents"><ul>', links, "</ul></nav>\n", ...
          '<main id="main">', "\n", parts, "</main>\n", footerOf(page), ...
          "</body>\n</html>\n"};
  file = fullfile (folder, 'report.html');
  writeAtomic (file, [html{:}]);
end

function [links, parts] = sectionsOf (page)
  links = '';
  parts = '';
  for section = pageSections ()
    name = func2str (section{1});
    try
      [title, html] = section{1} (page);
    catch err
      title = regexprep (name, '^section', '');
      html = ['<p class="off">This part could not be made: ', ...
              htmlText(err.message), '</p>'];
    end
    if ~isempty (html)
      id = lower (name);
      links = [links, '<li><a href="#', id, '">', title, '</a></li>'];
      head = ['<h2 id="h-', id, '">', title, "</h2>\n"];
      if ~any (strcmp (name, {'sectionTargets', 'sectionWhich', ...
                              'sectionChange'}))
        html = ['<details><summary>', head, '</summary>', html, '</details>'];
        head = '';
      end
      parts = [parts, '<section id="', id, '" aria-labelledby="h-', id, ...
               '">', head, html, "</section>\n"];
    end
  end
end

function html = headerOf (page, verdict)
  Case = page.Case;
  html = ['<header><h1>', htmlText(caseName (Case)), '</h1>', ...
          '<p class="where">', ...
          htmlText(strjoin ({Case.models.name}, ', ')), ' &middot; ', ...
          htmlText(pageDate (page)), "</p>\n", ...
          measuredBy(Case.folder), verdict, "</header>\n"];
end

% Remarks before the header of measured.csv: material, rig, date, who.
function html = measuredBy (folder)
  html = '';
  file = fullfile (folder, 'measured.csv');
  if isfile (file)
    found = regexp (fileread (file), '^#[ \t]*([^\r\n]*)', 'tokens', ...
                    'lineanchors');
    words = cellfun (@(t) htmlText(t{1}), found, 'UniformOutput', false);
    if ~isempty (words)
      html = ['<p class="where">Measured: ', ...
              strjoin(words, ' &middot; '), "</p>\n"];
    end
  end
end

function name = caseName (Case)
  [~, base, ending] = fileparts (Case.folder);
  name = ['Case ', base, ending];
end

function html = footerOf (page)
  html = ['<footer><p>DEcalioc ', ...
          htmlText(toolboxVersion (page.Case.root)), ...
          '. Page made on ', htmlText(strftime ('%Y-%m-%d %H:%M', ...
                                                localtime (time ()))), ...
          " from the files of the case folder.</p></footer>\n"];
end

% The parts in their order: [TITLE, HTML] = section (PAGE); HTML is '' where a
% case has nothing to show there.
function sections = pageSections ()
  sections = {@sectionTargets, @sectionWhich, @sectionChange, ...
              @sectionParameters, @sectionParticles, @sectionWhere, ...
              @sectionHowFar, @sectionNextTest, @sectionPlan, ...
              @sectionSlices, @sectionLeaveOneOut, @sectionSteps, ...
              @sectionSensitivity, @sectionRuns, @sectionSettings};
end

% When the result is from.
function text = pageDate (page)
  text = 'no result yet';
  for source = {'progress', 'calibration'}
    date = jsonAt (page.sources, {source{1}, 'date'});
    if ischar (date)
      text = date;
    end
  end
  file = fullfile (page.Case.folder, 'gap', 'gap.json');
  if ~isempty (page.sources.gap) && isfile (file)
    made = strftime ('%Y-%m-%d %H:%M', localtime (stat (file).mtime));
    text = [strrep(['calibrated ', text, ', '], ...
                   'calibrated no result yet, ', ''), 'diagnosed ', made];
  end
end

% The symbols of all figures, by the names of gnuplot, once a page.
function svg = houseSymbols ()
  line = 'stroke="currentColor"';
  fill = 'fill="currentColor"';
  svg = ['<svg width="0" height="0" class="symbols" aria-hidden="true">', ...
         '<defs>', ...
         '<path id="gpPt1" stroke-width=".4" ', line, ...
         ' d="M-1-1 1 1M1-1-1 1"/>', ...
         '<rect id="gpPt4" ', fill, ' x="-1" y="-1" width="2" height="2"/>', ...
         '<circle id="gpPt5" fill="none" stroke-width=".35" ', line, ...
         ' r="1"/>', ...
         '<circle id="gpPt6" ', fill, ' r="1"/>', ...
         '<path id="gpPt8" ', fill, ' d="M0-1.33-1.33.67 1.33.67z"/>', ...
         '<path id="gpPt12" ', fill, ' d="M0-1.5 1.5 0 0 1.5-1.5 0z"/>', ...
         "</defs></svg>\n"];
end

function writeRunTable (page)
  Case = page.Case;
  nEffects = numel (Case.effectVars);
  head = [{'model', 'folder', 'stage', 'status', 'cause', 'replicate', ...
           'seed', 'seconds', 'started'}, Case.names, Case.effectVars, ...
          {Case.targets.name}, {'message'}];
  lines = {strjoin(cellfun (@masked, head, 'UniformOutput', false), ',')};
  for run = page.runs
    effects = NaN (1, nEffects);
    n = numel (run.effects);
    if n == nEffects || n == numel (Case.coarse)
      effects(1:n) = run.effects;
    end
    numbers = [run.replicate, run.seed, run.seconds, run.started, ...
               run.params, effects, resultsOf(run, Case)];
    texts = arrayfun (@(x) sprintf ('%.17g', x), numbers, ...
                      'UniformOutput', false);
    texts(isnan (numbers)) = {''};
    words = cellfun (@masked, {run.model, run.name, run.stage, run.status, ...
                               run.cause}, 'UniformOutput', false);
    lines{end + 1} = strjoin ([words, texts, {masked(run.message)}], ',');
  end
  [~, ~] = mkdir (fullfile (Case.folder, 'results'));
  writeAtomic (fullfile (Case.folder, 'results', 'runTable.csv'), ...
               [strjoin(lines, "\n"), "\n"]);
end

function z = resultsOf (run, Case)
  z = NaN (1, numel (Case.targets));
  own = find (strcmp ({Case.targets.modelName}, run.model));
  for t = own
    index = Case.targets(t).index;
    if strcmp (run.status, 'ok') && numel (run.results) >= index
      z(t) = run.results(index);
    end
  end
end

function text = masked (text)
  text = text(:)';
  text(text < 32) = ' ';
  if any (ismember (text, ',;"'))
    text = ['"', strrep(text, '"', '""'), '"'];
  end
end

%!test
%! % before anything has been run; a text of the user that means something in
%! % HTML
%! raw = standInCase (tempname ());
%! raw.optim.targetName = {{'a <b> & c'}};
%! file = writePage (newCase (raw));
%! html = fileread (file);
%! assert (! isempty (strfind (html, 'a &lt;b&gt; &amp; c')));
%! assert (isempty (strfind (html, '<b>')));
%! assert (numel (strfind (html, ['content="default-src ''none''; ', ...
%!   'style-src ''unsafe-inline''; img-src data:"'])), 1);
%! assert (isempty (regexp (html, '<(script|link|img)', 'once')));
%! assert (isempty (strfind (html, 'could not be made')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');
%!test
%! raw = standInCase (tempname ());
%! raw.optim.targetName = {{'sum (N)', 'product'}};
%! Case = newCase (raw);
%! evaluateDEM ([1, 2; 3, 4], Case);
%! writePage (Case);
%! [head, cells] = readCsvTable (fullfile (Case.folder, 'results', ...
%!                                         'runTable.csv'));
%! assert (rows (cells), 4);
%! first = find (strcmp (cells(:, 1), 'First'));
%! sums = str2double (cells(first, strcmp (head, 'sum (N)')));
%! assert (sort (sums), [3; 7], 1e-12);
%! second = find (strcmp (cells(:, 1), 'Second'));
%! assert (all (cellfun (@isempty, cells(second, strcmp (head, 'product')))));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
