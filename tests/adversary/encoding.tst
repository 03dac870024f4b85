% Tables as programs save them: Excel's plain CSV (Windows-1252), its CSV UTF-8
% (with a mark), its "Unicode text" (UTF-16, tabs), with line ends of any kind.
% A degree sign or an umlaut anywhere in the files of a case stops nothing.

%!function bytes = saved (text, form)
%!  text = strrep (text, "\n", form.ends);
%!  bytes = char ([form.mark, unicode2native(text, form.encoding)]);
%!endfunction
%!function forms = allForms ()
%!  forms = struct ('encoding', {'UTF-8', 'windows-1252', 'UTF-8', ...
%!                               'UTF-16LE', 'UTF-16BE', 'windows-1252'}, ...
%!                  'mark', {[], [], [239, 187, 191], [255, 254], ...
%!                           [254, 255], []}, ...
%!                  'ends', {"\n", "\r\n", "\r\n", "\r\n", "\n", "\r"});
%!endfunction

%!shared folder, root, umlaut, degree, table
%! umlaut = char ([195, 182]);
%! degree = char ([194, 176]);
%! root = fileparts (fileparts (which ('startToolbox')));
%! folder = tempname ();
%! measuredCase (folder);
%! table = strrep (fileread (fullfile (folder, 'measured.csv')), ';kg;', ...
%!                 [';', degree, ';']);
%! table = ['# Pr', umlaut, "fstand\n", table];
%!test
%! % measured.csv and runs.csv: the same targets and runs in every form
%! results = fullfile (folder, 'DEMmodels', 'Bin', 'results.csv');
%! writeAtomic (results, ...
%!              char (unicode2native (strrep (strrep (fileread (results), ...
%!                                    'what stays', ['H', umlaut, 'he']), ...
%!                                    ',kg,', [',', degree, ',']), ...
%!                                    'windows-1252')));
%! runs = ["model,a,b,rest,drift,wide,H", umlaut, "he\nBin,1,2,3,4,5,6\n"];
%! here = cd (folder);
%! tidy = onCleanup (@() cd (here));
%! for form = allForms ()
%!   writeAtomic (fullfile (folder, 'measured.csv'), saved (table, form));
%!   clear ('loadInput');
%!   Case = loadCase (root, folder);
%!   units = unique ({Case.targets.unit});
%!   assert (any (strcmp (units, degree)), form.encoding);
%!   assert (numel (Case.targets), 33);     % 30 of the 50 of the curve
%!   writeAtomic (fullfile (folder, 'runs.csv'), saved (runs, form));
%!   [header, cells] = readCsvTable (fullfile (folder, 'runs.csv'));
%!   assert (header{7}, ['H', umlaut, 'he']);
%!   assert (cells(1, 2:7), {'1', '2', '3', '4', '5', '6'});
%! end
%! unlink (fullfile (folder, 'runs.csv'));
%! info = resultInfo (fileparts (results));
%! assert (info(2).text, ['H', umlaut, 'he']);
%!test
%! % a settings.csv, and what a program prints, with line ends of any kind
%! place = tempname ();
%! mkdir (place);
%! file = @(name) fullfile (place, name);
%! for form = allForms ()
%!   writeAtomic (file ('settings.csv'), ...
%!                saved (["variable,unit,values,text\nangle,", degree, ...
%!                        ",10 20,at %s\n"], form));
%!   assert (readSettings (place).unit, degree);
%!   writeAtomic (file ('out'), saved (["slope 33.1\nangle in ", degree, ...
%!                                      ": 20\nmass = 5\n"], form));
%!   assert (readResults (file ('out'), {'slope', 'mass'}), [33.1, 5]);
%! end
%! writeAtomic (file ('output_checks.csv'), ...
%!              [char(228), ",1\nspheresStart,3\nspheresOut,0\n", ...
%!               "spheresEnd,3\nsettled,1\noverlapMax,0.01\n"]);
%! assert (readChecks (place).sane);
%!test
%! % a getResults that complains in Windows-1252: a record that can be read
%! raw = standInCase (tempname ());
%! funs = fullfile (raw.folder, 'DEMmodels', 'Second', 'OctaveFuns');
%! writeAtomic (fullfile (funs, 'getResults.m'), ...
%!              ["function res = getResults (model, folderName)\n", ...
%!               "if isempty (getenv ('DECALIOC_NONE')), ", ...
%!               "error (['H', char(246), 'he fehlt']); end\nend\n"]);
%! setenv ('DECALIOC_NONE', '1');
%! Case = newCase (raw);
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(2);
%! setenv ('DECALIOC_NONE', '');
%! record = executeLocal (job, Case, @(state) []);
%! assert (record.status, 'invalid');
%! assert (~isempty (strfind (record.message, ['H', umlaut, 'he fehlt'])));
%! kept = readRecord (fullfile (record.folder, 'record.json'));
%! assert (kept.message, record.message);
%!test
%! % remarks in the other files, through the command and its page
%! for name = {'data.head', '#'; 'runscript', '#'; 'in.Bin', '#'; ...
%!             'bin.awk', '#'; 'OctaveFuns/getResults.m', '%'}'
%!   file = fullfile (folder, 'DEMmodels', 'Bin', name{1});
%!   lines = ostrsplit (fileread (file), "\n");
%!   lines{1} = [lines{1}, ' ', name{2}, ' H', char(246), 'he'];
%!   writeAtomic (file, strjoin (lines, "\n"));
%! end
%! writeAtomic (fullfile (folder, 'measured.csv'), ...
%!              saved (table, allForms ()(2)));
%! [status, text] = startCommand (folder, 'check');
%! assert (status == 0, text);
%! [status, text] = startCommand (folder, 'report');
%! assert (status == 0, text);
%! page = fileread (fullfile (folder, 'results', 'report.html'));
%! assert (~isempty (strfind (page, ['Pr', umlaut, 'fstand'])));
%! assert (asUtf8 (page), page);

% SPDX-License-Identifier: GPL-3.0-only
