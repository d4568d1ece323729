#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.0}
camera{perspective location <0.0,1.5e-07,-6e-07> direction <0.0,0.0,1.5> right <1.0,-0.0,0.0> up <0.0,1.0,0.0>}
light_source{<-4e-07,6e-07,-5e-07> rgb 1}
plane{<0.0,1.0,0.0>,0.0 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} }}
sphere{<0.0,1e-07,0.0>,1e-07 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} }}
box{<-5e-08,-5e-08,5e-08>,<5e-08,5e-08,-5e-08> pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} } rotate <-31.0,-17.0,53.0> translate <1.8999999999999998e-07,1e-07,-5e-08>}
triangle{<-3e-07,0.0,1e-07>,<-1e-07,0.0,2e-07>,<-2e-07,2.5e-07,1.5e-07> pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} }}
